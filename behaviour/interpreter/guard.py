# SPDX-License-Identifier: Apache-2.0
# The host's side of the behaviours. A Version is one loading of all their files: it has modules of
# its own (nothing is shared with sys.modules), so that an edited file replaces everything or
# nothing. A behaviour can import other behaviours, `kelpie` and `math`: no files, sockets, clocks
# or randomness. This keeps honest code repeatable; it does not stop hostile code. What behaviours
# print goes to `say`, which the host puts in here.
import _signal
import builtins
import math
import sys

WITHHELD = ('open', 'exec', 'eval', 'compile', 'input', 'breakpoint', 'exit', 'quit', 'copyright',
            'credits', 'license', 'id', 'globals', 'BaseException')
# What behaviours have in place of a module or a function that they have not.
INSTEAD = {
    'time datetime': 'world.time_s is the time of the frame',
    'random secrets uuid': 'nothing is random, so that a replay decides the same; world.frame and '
                           'world.game.player differ',
    'socket threading asyncio multiprocessing queue': 'mates hear Command.team, and are heard in '
                                                      'world.teammates',
    'os sys io pathlib posix shutil subprocess pickle json csv open': 'there are no files and no '
    'processes; numbers stand in a module of your own, and print() tells people',
    'logging warnings traceback pprint input breakpoint': 'print() tells people, an error tells '
                                                          'its line',
    'numpy scipy array statistics cmath decimal fractions': 'lists and math',
    're string textwrap': 'the methods of str',
    'typing types dataclasses enum abc collections itertools functools copy operator heapq bisect '
    'contextlib __future__': 'classes, lists, dicts and generators of plain Python',
    'exec eval compile globals importlib inspect': 'functions and classes of plain Python',
}
HELP_LINES = 8  # of what help() prints


# Importing _signal makes an interrupt an exception of Python's; it stays the program's.
if _signal.getsignal(_signal.SIGINT) is _signal.default_int_handler:
    _signal.signal(_signal.SIGINT, _signal.SIG_DFL)


class TimeLimit(BaseException):
    """Not an Exception: `except Exception` in a behaviour must not swallow it."""


compiled = {}  # (text, code) of each file; hosts that share the interpreter have it in common


def code_of(text, file):
    known = compiled.get(file)
    if known is None or known[0] != text:
        # 1: with docstrings, for help().
        known = text, compile(text, file, 'exec', dont_inherit=True, optimize=1)
        compiled[file] = known
    return known[1]


class Folder:
    def __init__(self, path):
        self.path = path

    def code(self, name):
        """(code, is a package) of a module, or None."""
        stem = self.path + '/' + name.replace('.', '/')
        for file, package in ((stem + '.py', False), (stem + '/__init__.py', True)):
            try:
                with open(file, 'rb') as stream:
                    return code_of(stream.read(), file), package
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


def say(line):
    """Takes a line for people; the host bounds it and puts a function of its own in here."""


def instead(name):
    """': ' and what there is in place of that name, or nothing."""
    return ''.join(': ' + there for names, there in INSTEAD.items() if name in names.split())


def listed(names):
    """Names in lines of eight."""
    return [', '.join(names[i:i + 8]) for i in range(0, len(names), 8)]


def described(thing):
    """Lines about a thing: its name, then its docstring or what it holds."""
    name = getattr(thing, '__name__', None) or type(thing).__name__
    code = getattr(thing, '__code__', None)
    if code is not None:
        name += '(' + ', '.join(code.co_varnames[:code.co_argcount + code.co_kwonlyargcount]) + ')'
    doc = getattr(thing, '__doc__', None)
    if isinstance(doc, str) and doc.strip():
        return [name] + ['  ' + line.strip() for line in doc.strip().splitlines() if line.strip()]
    names = [] if code is not None else [word for word in dir(thing) if not word.startswith('_')]
    return [name] + ['  ' + line for line in listed(names)]


class Printer:
    """print() and help() of behaviours. Keeps what is printed until its line ends."""
    def __init__(self):
        self.begun = ''

    def print(self, *values, sep=' ', end='\n', flush=False):
        """print(value, ..., sep=' ', end='\\n'): a line for people, so many a second"""
        line = self.begun + (' ' if sep is None else sep).join(map(str, values))
        *lines, self.begun = (line + ('\n' if end is None else end)).split('\n')
        if len(self.begun) > 1000:
            lines.append(self.begun)
            self.begun = ''
        for line in lines:
            say(line)

    def help(self, thing=None):
        """help(thing) prints what it is: its docstring, or the names that it has"""
        lines = described(self.help if thing is None else thing)
        for line in lines[:HELP_LINES]:
            say(line)
        if len(lines) > HELP_LINES:
            say('  ... %d more lines' % (len(lines) - HELP_LINES))


class Version:
    def __init__(self, source, kelpie):
        self.source = source
        self.modules = {}
        self.shared = {'math': math, 'kelpie': kelpie}
        self.builtins = {name: value for name, value in vars(builtins).items()
                         if name not in WITHHELD}
        self.builtins['__import__'] = self.bring
        printer = Printer()
        self.builtins['print'] = printer.print
        self.builtins['help'] = printer.help
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
        return ('behaviours may import math, kelpie and each other, not %r' % name +
                instead(name.partition('.')[0]))

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
    if isinstance(error, MemoryError) and not said:
        said = 'it takes more memory than it is given'
    if isinstance(error, NameError):
        said += instead(error.name or '')
    if isinstance(error, SyntaxError) and error.filename:
        said = error.msg
        places = ['%s:%s: in the text' % (error.filename, error.lineno)]
    where = places[-1].rpartition(': in ')[0] + ': ' if places else ''
    line = where + what + (': ' + said if said else '')
    if len(places) > 8:  # a recursion has a thousand
        places[4:-4] = ['... %d more' % (len(places) - 8)]
    trace = ['  ' + place for place in places] if len(places) > 1 else []
    return line, '\n'.join(trace + [line])
