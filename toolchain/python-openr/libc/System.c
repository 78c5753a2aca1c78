// SPDX-License-Identifier: Apache-2.0
// What CPython wants of an operating system, where there is none: no file opens, no signal comes,
// the clock stands still, the locale is C. What is written to standard output or error is kept for
// whoever drives the emulator. Every refusal sets errno, as CPython expects.
#include <errno.h>
#include <fcntl.h>
#include <locale.h>
#include <signal.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/time.h>
#include <time.h>
#include <unistd.h>

enum { kConsoleBytes = 64 << 10 };
static char console[kConsoleBytes];
static size_t written;

char* kelpieConsole(void) { return console; }
size_t kelpieConsoleSize(void) { return written; }

static void tell(const char* text, size_t size) {
  if (size > kConsoleBytes - written) size = kConsoleBytes - written;
  memcpy(console + written, text, size);
  written += size;
}

void kelpieTell(const char* text, size_t size) { tell(text, size); }

static int lastError;
int* __errno_location(void) { return &lastError; }

static int refuse(int why) {
  errno = why;
  return -1;
}

// --- ends
void abort(void) {
  tell("abort\n", 6);
  __builtin_trap();
}
void exit(int status) {
  (void)status;
  tell("exit\n", 5);
  __builtin_trap();
}
void _exit(int status) { exit(status); }

// --- standard streams: three names for the console, of which nothing can be read
static char streams[3];
FILE* stdin = (FILE*)&streams[0];
FILE* stdout = (FILE*)&streams[1];
FILE* stderr = (FILE*)&streams[2];

int fileno(FILE* stream) { return (int)((char*)stream - streams); }
size_t fwrite(const void* from, size_t size, size_t count, FILE* stream) {
  (void)stream;
  tell(from, size * count);
  return count;
}
int fputs(const char* text, FILE* stream) {
  fwrite(text, 1, strlen(text), stream);
  return 0;
}
int fputc(int c, FILE* stream) {
  const char one = (char)c;
  fwrite(&one, 1, 1, stream);
  return c;
}
int putc(int c, FILE* stream) { return fputc(c, stream); }
int putchar(int c) { return fputc(c, stdout); }
int puts(const char* text) { return fputs(text, stdout), fputc('\n', stdout); }
int vfprintf(FILE* stream, const char* format, va_list arguments) {
  char line[512];
  const int length = vsnprintf(line, sizeof line, format, arguments);
  fputs(line, stream);
  return length;
}
int fprintf(FILE* stream, const char* format, ...) {
  va_list arguments;
  va_start(arguments, format);
  const int length = vfprintf(stream, format, arguments);
  va_end(arguments);
  return length;
}
int printf(const char* format, ...) {
  va_list arguments;
  va_start(arguments, format);
  const int length = vfprintf(stdout, format, arguments);
  va_end(arguments);
  return length;
}
int fflush(FILE* stream) { return (void)stream, 0; }
int ferror(FILE* stream) { return (void)stream, 0; }
int feof(FILE* stream) { return (void)stream, 1; }
void clearerr(FILE* stream) { (void)stream; }
int fclose(FILE* stream) { return (void)stream, 0; }
int getc(FILE* stream) { return (void)stream, EOF; }
int fgetc(FILE* stream) { return (void)stream, EOF; }
int ungetc(int c, FILE* stream) { return (void)stream, (void)c, EOF; }
char* fgets(char* to, int size, FILE* stream) { return (void)to, (void)size, (void)stream, NULL; }
size_t fread(void* to, size_t size, size_t count, FILE* stream) {
  return (void)to, (void)size, (void)count, (void)stream, 0;
}
FILE* fopen(const char* path, const char* mode) {
  (void)path, (void)mode;
  return errno = ENOENT, NULL;
}
FILE* fdopen(int file, const char* mode) { return (void)file, (void)mode, errno = EBADF, NULL; }
int setvbuf(FILE* stream, char* buffer, int mode, size_t size) {
  return (void)stream, (void)buffer, (void)mode, (void)size, 0;
}
void setbuf(FILE* stream, char* buffer) { (void)stream, (void)buffer; }
long ftell(FILE* stream) { return (void)stream, refuse(EBADF); }
void rewind(FILE* stream) { (void)stream; }
void perror(const char* text) { fputs(text, stderr); }

// --- files
int open(const char* path, int flags, ...) { return (void)path, (void)flags, refuse(ENOENT); }
int close(int file) { return (void)file, refuse(EBADF); }
int dup(int file) { return (void)file, refuse(EBADF); }
int fcntl(int file, int command, ...) { return (void)file, (void)command, refuse(EBADF); }
int ioctl(int file, unsigned long request, ...) { return (void)file, (void)request, refuse(EBADF); }
ssize_t read(int file, void* to, size_t size) {
  return (void)file, (void)to, (void)size, refuse(EBADF);
}
ssize_t write(int file, const void* from, size_t size) {
  if (file != 1 && file != 2) return refuse(EBADF);
  tell(from, size);
  return (ssize_t)size;
}
off_t lseek(int file, off_t to, int from) {
  return (void)file, (void)to, (void)from, refuse(ESPIPE);
}
int isatty(int file) { return (void)file, errno = ENOTTY, 0; }
int stat(const char* path, struct stat* into) { return (void)path, (void)into, refuse(ENOENT); }
int fstat(int file, struct stat* into) { return (void)file, (void)into, refuse(EBADF); }
char* getcwd(char* to, size_t size) { return (void)to, (void)size, errno = ENOENT, NULL; }
char* realpath(const char* path, char* to) { return (void)path, (void)to, errno = ENOENT, NULL; }
ssize_t readlink(const char* path, char* to, size_t size) {
  return (void)path, (void)to, (void)size, refuse(ENOENT);
}
int ftruncate(int file, off_t size) { return (void)file, (void)size, refuse(EBADF); }

// --- environment, locale
char* getenv(const char* name) { return (void)name, NULL; }
int setenv(const char* name, const char* value, int anew) {
  return (void)name, (void)value, (void)anew, 0;
}
long syscall(long number, ...) { return (void)number, refuse(ENOSYS); }
long sysconf(int name) { return (void)name, refuse(EINVAL); }
static char localeName[] = "C";
char* setlocale(int category, const char* wanted) {
  return (void)category, (void)wanted, localeName;
}
struct lconv* localeconv(void) {
  static char empty[] = "", point[] = ".";
  static struct lconv c = {.decimal_point = point, .thousands_sep = empty, .grouping = empty};
  return &c;
}
char* nl_langinfo(int item) {
  (void)item;
  static char ascii[] = "ANSI_X3.4-1968";
  return ascii;
}
char* strerror(int number) {
  static char text[24];
  snprintf(text, sizeof text, "errno %d", number);
  return text;
}

// --- time stands still: a stage has no clock, and what decides may not have one either
int gettimeofday(struct timeval* now, void* zone) {
  (void)zone;
  *now = (struct timeval){0};
  return 0;
}
int clock_gettime(clockid_t clock, struct timespec* now) {
  (void)clock;
  *now = (struct timespec){0};
  return 0;
}
int clock_getres(clockid_t clock, struct timespec* step) {
  (void)clock;
  *step = (struct timespec){.tv_nsec = 1000000};
  return 0;
}
time_t time(time_t* now) { return now != NULL ? *now = 0 : 0; }
struct tm* localtime_r(const time_t* when, struct tm* into) {
  return (void)when, (void)into, NULL;
}
struct tm* gmtime_r(const time_t* when, struct tm* into) {
  return (void)when, (void)into, NULL;
}

// --- signals: none comes
typedef void (*Handler)(int);
Handler signal(int number, Handler handler) { return (void)number, (void)handler, SIG_DFL; }
int raise(int number) { return (void)number, refuse(EINVAL); }
int sigaction(int number, const struct sigaction* wanted, struct sigaction* before) {
  (void)number, (void)wanted;
  if (before != NULL) memset(before, 0, sizeof *before);
  return 0;
}
int siginterrupt(int number, int flag) { return (void)number, (void)flag, 0; }
int __libc_current_sigrtmin(void) { return refuse(EINVAL); }
int __libc_current_sigrtmax(void) { return refuse(EINVAL); }
char* strsignal(int number) { return (void)number, localeName; }
