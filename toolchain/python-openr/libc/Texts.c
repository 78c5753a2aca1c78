// SPDX-License-Identifier: Apache-2.0
// Bytes, texts and wide texts of the C library that CPython calls, with one locale: C, whose
// characters are those of ASCII. Numbers are printed as CPython asks for them: no floating point,
// which it formats itself (Python/dtoa.c).
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>
#include <wchar.h>

void* memcpy(void* to, const void* from, size_t count) {
  uint8_t* out = to;
  const uint8_t* in = from;
  if ((((uintptr_t)out | (uintptr_t)in) & 3) == 0)
    for (; count >= 4; count -= 4, out += 4, in += 4) *(uint32_t*)out = *(const uint32_t*)in;
  while (count-- > 0) *out++ = *in++;
  return to;
}

void* memmove(void* to, const void* from, size_t count) {
  uint8_t* const out = to;
  const uint8_t* const in = from;
  if (out <= in || out >= in + count) return memcpy(to, from, count);
  while (count-- > 0) out[count] = in[count];
  return to;
}

void* memset(void* to, int value, size_t count) {
  for (uint8_t* out = to; count-- > 0;) *out++ = (uint8_t)value;
  return to;
}

int memcmp(const void* a, const void* b, size_t count) {
  const uint8_t *left = a, *right = b;
  for (; count-- > 0; ++left, ++right)
    if (*left != *right) return *left - *right;
  return 0;
}

void* memchr(const void* from, int value, size_t count) {
  for (const uint8_t* in = from; count-- > 0; ++in)
    if (*in == (uint8_t)value) return (void*)in;
  return NULL;
}

void* memrchr(const void* from, int value, size_t count) {
  const uint8_t* const in = from;
  while (count-- > 0)
    if (in[count] == (uint8_t)value) return (void*)(in + count);
  return NULL;
}

size_t strlen(const char* text) {
  size_t length = 0;
  while (text[length] != '\0') ++length;
  return length;
}

int strncmp(const char* a, const char* b, size_t most) {
  for (; most-- > 0; ++a, ++b)
    if (*a != *b || *a == '\0') return (uint8_t)*a - (uint8_t)*b;
  return 0;
}
int strcmp(const char* a, const char* b) { return strncmp(a, b, SIZE_MAX); }

char* strcpy(char* to, const char* from) { return memcpy(to, from, strlen(from) + 1); }
char* strncpy(char* to, const char* from, size_t size) {
  size_t i = 0;
  for (; i < size && from[i] != '\0'; ++i) to[i] = from[i];
  memset(to + i, 0, size - i);
  return to;
}
char* strcat(char* to, const char* from) {
  strcpy(to + strlen(to), from);
  return to;
}
char* strchr(const char* text, int wanted) { return memchr(text, wanted, strlen(text) + 1); }
char* strrchr(const char* text, int wanted) { return memrchr(text, wanted, strlen(text) + 1); }
char* strstr(const char* text, const char* wanted) {
  const size_t length = strlen(wanted);
  for (; *text != '\0'; ++text)
    if (strncmp(text, wanted, length) == 0) return (char*)text;
  return length == 0 ? (char*)text : NULL;
}
size_t strcspn(const char* text, const char* any) {
  size_t length = 0;
  while (text[length] != '\0' && strchr(any, text[length]) == NULL) ++length;
  return length;
}
char* strpbrk(const char* text, const char* any) {
  for (; *text != '\0'; ++text)
    if (strchr(any, *text) != NULL) return (char*)text;
  return NULL;
}

static int digitOf(int c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'z') return c - 'a' + 10;
  return c >= 'A' && c <= 'Z' ? c - 'A' + 10 : 99;
}

unsigned long strtoul(const char* text, char** end, int base) {
  const bool negative = *text == '-';
  if (negative || *text == '+') ++text;
  if ((base == 0 || base == 16) && text[0] == '0' && (text[1] | 32) == 'x') text += 2, base = 16;
  if (base == 0) base = *text == '0' ? 8 : 10;
  unsigned long value = 0;
  for (; digitOf(*text) < base; ++text) value = value * (unsigned)base + (unsigned)digitOf(*text);
  if (end != NULL) *end = (char*)text;
  return negative ? -value : value;
}
long strtol(const char* text, char** end, int base) { return (long)strtoul(text, end, base); }
int atoi(const char* text) { return (int)strtol(text, NULL, 10); }

size_t wcslen(const wchar_t* text) {
  size_t length = 0;
  while (text[length] != 0) ++length;
  return length;
}
int wcsncmp(const wchar_t* a, const wchar_t* b, size_t most) {
  for (; most-- > 0; ++a, ++b)
    if (*a != *b || *a == 0) return *a < *b ? -1 : *a > *b;
  return 0;
}
int wcscmp(const wchar_t* a, const wchar_t* b) { return wcsncmp(a, b, SIZE_MAX); }
int wmemcmp(const wchar_t* a, const wchar_t* b, size_t count) {
  for (; count-- > 0; ++a, ++b)
    if (*a != *b) return *a < *b ? -1 : 1;
  return 0;
}
wchar_t* wcscpy(wchar_t* to, const wchar_t* from) {
  return memcpy(to, from, (wcslen(from) + 1) * sizeof(wchar_t));
}
wchar_t* wcsncpy(wchar_t* to, const wchar_t* from, size_t size) {
  size_t i = 0;
  for (; i < size && from[i] != 0; ++i) to[i] = from[i];
  for (; i < size; ++i) to[i] = 0;
  return to;
}
wchar_t* wcschr(const wchar_t* text, wchar_t wanted) {
  for (; *text != wanted; ++text)
    if (*text == 0) return NULL;
  return (wchar_t*)text;
}
wchar_t* wcsrchr(const wchar_t* text, wchar_t wanted) {
  for (size_t at = wcslen(text) + 1; at-- > 0;)
    if (text[at] == wanted) return (wchar_t*)(text + at);
  return NULL;
}
size_t mbstowcs(wchar_t* to, const char* from, size_t size) {
  size_t i = 0;
  for (; to == NULL || i < size; ++i) {
    if ((uint8_t)from[i] > 127) return (size_t)-1;
    if (to != NULL) to[i] = from[i];
    if (from[i] == '\0') break;
  }
  return i;
}
size_t wcstombs(char* to, const wchar_t* from, size_t size) {
  size_t i = 0;
  for (; to == NULL || i < size; ++i) {
    if (from[i] < 0 || from[i] > 127) return (size_t)-1;
    if (to != NULL) to[i] = (char)from[i];
    if (from[i] == 0) break;
  }
  return i;
}
size_t mbrtowc(wchar_t* to, const char* from, size_t size, mbstate_t* state) {
  (void)state;
  if (size == 0) return (size_t)-2;
  if ((uint8_t)*from > 127) return (size_t)-1;
  if (to != NULL) *to = *from;
  return *from != '\0';
}
long wcstol(const wchar_t* text, wchar_t** end, int base) {
  char narrow[32];
  size_t i = 0;
  for (; i + 1 < sizeof narrow && text[i] > 0 && text[i] < 128; ++i) narrow[i] = (char)text[i];
  narrow[i] = '\0';
  char* stopped;
  const long value = strtol(narrow, &stopped, base);
  if (end != NULL) *end = (wchar_t*)text + (stopped - narrow);
  return value;
}
wchar_t* wcstok(wchar_t* text, const wchar_t* any, wchar_t** rest) {
  if (text == NULL) text = *rest;
  while (*text != 0 && wcschr(any, *text) != NULL) ++text;
  if (*text == 0) return NULL;
  wchar_t* const token = text;
  while (*text != 0 && wcschr(any, *text) == NULL) ++text;
  *rest = *text == 0 ? text : text + 1;
  *text = 0;
  return token;
}

// --- printing

typedef struct Out {
  char* to;
  size_t size;
  size_t length;  // of the whole text, also of what did not fit
} Out;

static void put(Out* out, char c) {
  if (out->length + 1 < out->size) out->to[out->length] = c;
  ++out->length;
}

typedef struct Form {
  bool left, zero, plus, alternate;
  int width, precision;
} Form;

static void putPadded(Out* out, const Form* form, const char* head, const char* text, int length,
                      int zeros) {
  const int whole = (int)strlen(head) + zeros + length;
  const int gap = form->width > whole ? form->width - whole : 0;
  const bool inside = form->zero && !form->left && form->precision < 0;
  if (!form->left && !inside)
    for (int i = 0; i < gap; ++i) put(out, ' ');
  while (*head != '\0') put(out, *head++);
  for (int i = 0; i < zeros + (inside ? gap : 0); ++i) put(out, '0');
  for (int i = 0; i < length; ++i) put(out, text[i]);
  if (form->left)
    for (int i = 0; i < gap; ++i) put(out, ' ');
}

static void putNumber(Out* out, const Form* form, uint64_t value, bool negative, char kind) {
  const unsigned base = kind == 'x' || kind == 'X' || kind == 'p' ? 16 : kind == 'o' ? 8 : 10;
  const char* const digits = kind == 'X' ? "0123456789ABCDEF" : "0123456789abcdef";
  char text[24];
  int at = sizeof text;
  do text[--at] = digits[value % base];
  while ((value /= base) != 0);
  const int length = (int)sizeof text - at;
  const char* const head = negative                                         ? "-"
                           : form->plus                                     ? "+"
                           : kind == 'p' || (form->alternate && base == 16) ? "0x"
                                                                            : "";
  putPadded(out, form, head, text + at, length,
            form->precision > length ? form->precision - length : 0);
}

static const char* readForm(const char* format, Form* form, va_list* arguments) {
  *form = (Form){.precision = -1};
  for (;; ++format) {
    if (*format == '-')
      form->left = true;
    else if (*format == '0')
      form->zero = true;
    else if (*format == '+')
      form->plus = true;
    else if (*format == '#')
      form->alternate = true;
    else
      break;
  }
  if (*format == '*') form->width = va_arg(*arguments, int), ++format;
  while (*format >= '0' && *format <= '9') form->width = 10 * form->width + *format++ - '0';
  if (*format != '.') return format;
  form->precision = 0;
  if (*++format == '*') return form->precision = va_arg(*arguments, int), format + 1;
  while (*format >= '0' && *format <= '9') form->precision = 10 * form->precision + *format++ - '0';
  return format;
}

static void putText(Out* out, const Form* form, const char* text) {
  if (text == NULL) text = "(null)";
  int length = 0;
  while ((form->precision < 0 || length < form->precision) && text[length] != '\0') ++length;
  const Form plain = {.left = form->left, .width = form->width, .precision = 0};
  putPadded(out, &plain, "", text, length, 0);
}

static const char* putOne(Out* out, const char* format, va_list* arguments) {
  Form form;
  format = readForm(format, &form, arguments);
  bool wide = false;  // 64 bits: long, size_t and pointers have 32 here
  for (; strchr("hljzt", *format) != NULL && *format != '\0'; ++format)
    wide = wide || *format == 'j' || (format[0] == 'l' && format[1] == 'l');
  const char kind = *format;
  if (kind == 's') {
    putText(out, &form, va_arg(*arguments, const char*));
  } else if (kind == 'c') {
    put(out, (char)va_arg(*arguments, int));
  } else if (kind == 'd' || kind == 'i') {
    const int64_t value = wide ? va_arg(*arguments, int64_t) : va_arg(*arguments, int);
    putNumber(out, &form, value < 0 ? -(uint64_t)value : (uint64_t)value, value < 0, 'd');
  } else if (kind != '\0' && strchr("uxXop", kind) != NULL) {
    putNumber(out, &form, wide ? va_arg(*arguments, uint64_t) : va_arg(*arguments, unsigned), false,
              kind);
  } else {
    put(out, kind);  // "%%", and what this does not know
  }
  return kind == '\0' ? format : format + 1;
}

int vsnprintf(char* to, size_t size, const char* format, va_list given) {
  va_list arguments;
  va_copy(arguments, given);
  Out out = {to, size, 0};
  while (*format != '\0') {
    if (*format != '%')
      put(&out, *format++);
    else
      format = putOne(&out, format + 1, &arguments);
  }
  if (size > 0) to[out.length < size ? out.length : size - 1] = '\0';
  va_end(arguments);
  return (int)out.length;
}

int snprintf(char* to, size_t size, const char* format, ...) {
  va_list arguments;
  va_start(arguments, format);
  const int length = vsnprintf(to, size, format, arguments);
  va_end(arguments);
  return length;
}

int sprintf(char* to, const char* format, ...) {
  va_list arguments;
  va_start(arguments, format);
  const int length = vsnprintf(to, 1 << 20, format, arguments);
  va_end(arguments);
  return length;
}
