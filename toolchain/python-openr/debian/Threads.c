// SPDX-License-Identifier: Apache-2.0
// Only for the trial with Debian's libpython3.11-pic.a, which was compiled with glibc's threads,
// 64-bit file functions and checking functions: one thread, locks that count, and the plain
// functions under the other names. Our own build of CPython (pyconfig.h) asks for none of these.
#include <errno.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

static int missing(void) {
  errno = ENOSYS;
  return -1;
}

#define DOES_NOTHING(name) \
  int name(void) { return 0; }
DOES_NOTHING(pthread_attr_init)
DOES_NOTHING(pthread_attr_destroy) DOES_NOTHING(pthread_attr_setscope) DOES_NOTHING(
    pthread_attr_setstacksize) DOES_NOTHING(pthread_cond_init) DOES_NOTHING(pthread_cond_destroy)
    DOES_NOTHING(pthread_cond_signal) DOES_NOTHING(pthread_cond_wait)
        DOES_NOTHING(pthread_cond_timedwait) DOES_NOTHING(pthread_condattr_init) DOES_NOTHING(
            pthread_condattr_setclock) DOES_NOTHING(pthread_detach) DOES_NOTHING(pthread_mutex_init)
            DOES_NOTHING(pthread_mutex_destroy) DOES_NOTHING(pthread_mutex_lock)
                DOES_NOTHING(pthread_mutex_unlock) DOES_NOTHING(pthread_sigmask)
                    DOES_NOTHING(sem_destroy) DOES_NOTHING(flockfile) DOES_NOTHING(funlockfile)
                        DOES_NOTHING(sigemptyset) DOES_NOTHING(sigfillset) DOES_NOTHING(sigismember)
                            DOES_NOTHING(sigaddset) DOES_NOTHING(sigaltstack)
#define IS_MISSING(name) \
  int name(void) { return missing(); }
                                IS_MISSING(pthread_create) IS_MISSING(pthread_kill) IS_MISSING(
                                    sigpending) IS_MISSING(sigwait) IS_MISSING(sigwaitinfo)
                                    IS_MISSING(sigtimedwait) IS_MISSING(alarm) IS_MISSING(pause)
                                        IS_MISSING(getitimer) IS_MISSING(setitimer)
                                            IS_MISSING(syscall) IS_MISSING(getrandom)
                                                IS_MISSING(close_range) IS_MISSING(confstr)
                                                    IS_MISSING(ftruncate64) IS_MISSING(fcntl64)
                                                        IS_MISSING(fstat64) IS_MISSING(__sysconf)
                                                            IS_MISSING(__libc_current_sigrtmin)
                                                                IS_MISSING(__libc_current_sigrtmax)

                                                                    static int noFile(void) {
  errno = ENOENT;
  return -1;
}
int stat64(void) { return noFile(); }
int open64(void) { return noFile(); }
int __open64_2(void) { return noFile(); }
void* fopen64(const char* path, const char* mode) { return (void)path, (void)mode, NULL; }
long long lseek64(int file, long long to, int from) {
  return (void)file, (void)to, (void)from, missing();
}
char* __realpath_chk(void) { return NULL; }
int __uflow(void* stream) { return (void)stream, -1; }
void* mmap64(void* wanted, size_t size) {
  (void)wanted;
  void* const memory = calloc(1, size);
  return memory != NULL ? memory : (void*)-1;
}
int munmap(void* memory, size_t size) {
  (void)size;
  free(memory);
  return 0;
}

uint32_t pthread_self(void) { return 1; }
void pthread_exit(void* value) {
  (void)value;
  abort();
}
static void* keys[32];
static unsigned keyCount;
int pthread_key_create(unsigned* key, void* destructor) {
  (void)destructor;
  if (keyCount == 32) return EAGAIN;
  *key = keyCount++;
  return 0;
}
int pthread_key_delete(unsigned key) { return (void)key, 0; }
void* pthread_getspecific(unsigned key) { return keys[key]; }
int pthread_setspecific(unsigned key, void* value) {
  keys[key] = value;
  return 0;
}

int sem_init(int* lock, int shared, unsigned count) {
  (void)shared;
  *lock = (int)count;
  return 0;
}
int sem_trywait(int* lock) {
  if (*lock > 0) return --*lock, 0;
  errno = EAGAIN;
  return -1;
}
int sem_wait(int* lock) { return sem_trywait(lock); }
int sem_clockwait(int* lock) { return sem_trywait(lock); }
int sem_post(int* lock) { return ++*lock, 0; }

// The checking functions, which do not check here.
int vsnprintf(char* to, size_t size, const char* format, va_list arguments);
int vfprintf(void* stream, const char* format, va_list arguments);
extern void* stdout;
int __vsnprintf_chk(char* to, size_t size, int flag, size_t has, const char* format, va_list a) {
  return (void)flag, (void)has, vsnprintf(to, size, format, a);
}
int __snprintf_chk(char* to, size_t size, int flag, size_t has, const char* format, ...) {
  va_list arguments;
  va_start(arguments, format);
  const int length = __vsnprintf_chk(to, size, flag, has, format, arguments);
  va_end(arguments);
  return length;
}
int __sprintf_chk(char* to, int flag, size_t has, const char* format, ...) {
  va_list arguments;
  va_start(arguments, format);
  const int length = __vsnprintf_chk(to, 1 << 20, flag, has, format, arguments);
  va_end(arguments);
  return length;
}
int __vfprintf_chk(void* stream, int flag, const char* format, va_list arguments) {
  return (void)flag, vfprintf(stream, format, arguments);
}
int __fprintf_chk(void* stream, int flag, const char* format, ...) {
  va_list arguments;
  va_start(arguments, format);
  const int length = vfprintf(stream, format, arguments);
  va_end(arguments);
  return (void)flag, length;
}
int __printf_chk(int flag, const char* format, ...) {
  va_list arguments;
  va_start(arguments, format);
  const int length = vfprintf(stdout, format, arguments);
  va_end(arguments);
  return (void)flag, length;
}
void* __memcpy_chk(void* to, const void* from, size_t count, size_t has) {
  return (void)has, memcpy(to, from, count);
}
void* __memmove_chk(void* to, const void* from, size_t count, size_t has) {
  return (void)has, memmove(to, from, count);
}
char* __strcpy_chk(char* to, const char* from, size_t has) { return (void)has, strcpy(to, from); }
char* __strcat_chk(char* to, const char* from, size_t has) { return (void)has, strcat(to, from); }

#undef errno
__thread int errno;  // of libm's own objects, which know it by this name

void* dlopen(const char* path, int mode) { return (void)path, (void)mode, NULL; }
void* dlsym(void* file, const char* name) { return (void)file, (void)name, NULL; }
char* dlerror(void) {
  static char text[] = "no libraries are loaded here";
  return text;
}
double frexp(double x, int* exponent);
double ldexp(double x, int exponent);
double __frexp(double x, int* exponent) { return frexp(x, exponent); }
double __ldexp(double x, int exponent) { return ldexp(x, exponent); }

void* __stack_chk_guard = (void*)0x0aff0d00;
void __stack_chk_fail(void) { abort(); }

// Of posixmodule.c, which would bring everything else along.
int _Py_Sigset_Converter(void) { return 0; }
void* _PyLong_FromUid(void) { return NULL; }

// Characters of the locale C. A table begins 128 before the character 0; glibc's bits (ctype.h).
enum {
  blank = 1,
  cntrl = 2,
  punct = 4,
  alnum = 8,
  upper = 0x100,
  lower = 0x200,
  alpha = 0x400,
  digit = 0x800,
  xdigit = 0x1000,
  space = 0x2000,
  print = 0x4000,
  graph = 0x8000
};
static uint16_t kinds[384];
static int32_t lowers[384];
static const uint16_t* kindsAt = kinds + 128;
static const int32_t* lowersAt = lowers + 128;
static int made;
static uint16_t kindOf(int c) {
  const int isUpper = c >= 'A' && c <= 'Z', isLower = c >= 'a' && c <= 'z';
  const int isDigit = c >= '0' && c <= '9', isHex = isDigit || ((c | 32) >= 'a' && (c | 32) <= 'f');
  int kind = (isUpper ? upper | alpha | alnum : 0) | (isLower ? lower | alpha | alnum : 0) |
             (isDigit ? digit | alnum : 0) | (isHex ? xdigit : 0);
  if (c == ' ' || (c >= 9 && c <= 13)) kind |= space;
  if (c == ' ' || c == 9) kind |= blank;
  if (c < 32 || c == 127) kind |= cntrl;
  if (c >= 32 && c < 127) kind |= print;
  if (c > 32 && c < 127) kind |= graph | (kind & alnum ? 0 : punct);
  return (uint16_t)kind;
}
static void makeTables(void) {
  for (int c = 0; c < 128; ++c) {
    kinds[128 + c] = kindOf(c);
    lowers[128 + c] = c >= 'A' && c <= 'Z' ? c | 32 : c;
  }
  made = 1;
}
const uint16_t** __ctype_b_loc(void) {
  if (!made) makeTables();
  return &kindsAt;
}
const int32_t** __ctype_tolower_loc(void) {
  if (!made) makeTables();
  return &lowersAt;
}
