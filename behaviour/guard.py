# SPDX-License-Identifier: Apache-2.0
# The host's side of the behaviours. A Version is one loading of all their files: it has modules of
# its own (nothing is shared with sys.modules), so that an edited file replaces everything or
# nothing. A behaviour can import other behaviours, `kelpie` and `math`: no files, sockets, clocks
# or randomness. This keeps honest code repeatable; it does not stop hostile code.
import _signal
import builtins
import math
import sys

WITHHELD = ('open', 'exec', 'eval', 'compile', 'input', 'print', 'breakpoint', 'help', 'exit',
            'quit', 'copyright', 'credits', 'license', 'id', 'globals', 'BaseException')


# Importing _signal makes an interrupt an exception of Python's; it stays the program's.
if _signal.getsignal(_signal.SIGINT) is _signal.default_int_handler:
    _signal.signal(_signal.SIGINT, _signal.SIG_DFL)


class TimeLimit(BaseException):
    """Not an Exception: `except Exception` in a behaviour must not swallow it."""


class Folder:
    def __init__(self, path):
        self.path = path

    def code(self, name):
        """(code, is a package) of a module, or None."""
        stem = self.path + '/' + name.replace('.', '/')
        for file, package in ((stem + '.py', False), (stem + '/__init__.py', True)):
            try:
                with open(file, 'rb') as stream:
                    return compile(stream.read(), file, 'exec', dont_inherit=True), package
            except (FileNotFoundError, NotADirectoryError):
                pass
        return self.namespace(stem)

    def namespace(self, stem):
        """An empty package for a folder without __init__.py, or None."""
        import posix
        try:
            posix.listdir(stem)
        except OSError:
            return None
        return compile('', stem, 'exec'), True


class Zip:
    def __init__(self, path):
        import zipimport
        self.importer = zipimport.zipimporter(path)
        self.missing = zipimport.ZipImportError

    def code(self, name):
        stem = name.rpartition('.')
        if stem[0]:
            # A zipimporter knows one folder of the zip; its last part is the module.
            import zipimport
            inside = self.importer.archive + '/' + stem[0].replace('.', '/')
            try:
                return self.read(zipimport.zipimporter(inside), stem[2])
            except self.missing:
                return None
        return self.read(self.importer, name)

    def read(self, importer, name):
        try:
            return importer.get_code(name), importer.is_package(name)
        except self.missing:
            pass
        prefix = importer.prefix + name + '/'
        if any(file.startswith(prefix) for file in importer._files):
            return compile('', importer.archive, 'exec'), True
        return None


class Version:
    def __init__(self, source, kelpie):
        self.source = source
        self.modules = {}
        self.shared = {'math': math, 'kelpie': kelpie}
        self.builtins = {name: value for name, value in vars(builtins).items()
                         if name not in WITHHELD}
        self.builtins['__import__'] = self.bring
        self.decide = getattr(self.load('main'), 'decide', None)
        if self.decide is None:
            raise AttributeError('main.py has no decide(world)')

    def ask(self, name):
        """What a function of main.py that takes nothing answers: a list of lists of texts."""
        function = getattr(self.modules['main'], name, None)
        if function is None:
            raise AttributeError('main.py has no %s()' % name)
        return [[str(cell) for cell in ((row,) if isinstance(row, str) else row)]
                for row in function()]

    def missing(self, name):
        if name == 'main':
            return 'there is no main.py'
        return 'behaviours may import math, kelpie and each other, not %r' % name

    def bring(self, name, globals=None, locals=None, fromlist=(), level=0):
        if level:
            raise ImportError('behaviours import each other by full name')
        module = self.load(name)
        for item in fromlist or ():
            if not hasattr(module, item) and getattr(module, '__path__', None) is not None:
                self.load(name + '.' + item)
        return module if fromlist else self.load(name.partition('.')[0])

    def load(self, name):
        """The module of that full name, run at its first import; those above it come first."""
        known = self.shared.get(name) or self.modules.get(name)
        if known is not None:
            return known
        above, _, last = name.rpartition('.')
        parent = self.load(above) if above else None
        found = self.source.code(name)
        if found is None:
            raise ModuleNotFoundError(self.missing(name))
        module = type(sys)(name)
        module.__dict__['__builtins__'] = self.builtins
        if found[1]:
            module.__path__ = []
        self.modules[name] = module
        try:
            exec(found[0], module.__dict__)
        except BaseException:
            del self.modules[name]
            raise
        if parent is not None:
            setattr(parent, last, module)
        return module


def load(path, is_zip, kelpie):
    return Version(Zip(path) if is_zip else Folder(path), kelpie)


def on_time_limit(number, frame):
    # A bare `except:` would swallow one exception: the tracer raises again on the next line.
    def trace(frame, event, argument):
        raise TimeLimit('it takes more time than it is given')
    while frame is not None:
        frame.f_trace = trace
        frame = frame.f_back
    sys.settrace(trace)
    raise TimeLimit('it takes more time than it is given')


def watch():
    """Makes the watchdog's signal an exception."""
    _signal.signal(_signal.SIGVTALRM, on_time_limit)


def calm():
    """Ends what on_time_limit() began."""
    sys.settrace(None)


def make_kelpie(text):
    module = type(sys)('kelpie')
    exec(compile(text, 'kelpie', 'exec'), module.__dict__)
    return module


def describe(error):
    """One line with file and line, and that line behind its traceback if there is more to tell."""
    places = []
    step = error.__traceback__
    while step is not None:
        code = step.tb_frame.f_code
        if code.co_filename != '<guard>':
            places.append('%s:%d' % (code.co_filename, step.tb_lineno) + ': in ' + code.co_name)
        step = step.tb_next
    what = type(error).__name__
    try:
        said = str(error)
    except Exception:
        said = ''
    if isinstance(error, SyntaxError) and error.filename:
        said = error.msg
        places = ['%s:%s: in the text' % (error.filename, error.lineno)]
    where = places[-1].rpartition(': in ')[0] + ': ' if places else ''
    line = where + what + (': ' + said if said else '')
    if len(places) > 8:  # a recursion has a thousand
        places[4:-4] = ['... %d more' % (len(places) - 8)]
    trace = ['  ' + place for place in places] if len(places) > 1 else []
    return line, '\n'.join(trace + [line])
