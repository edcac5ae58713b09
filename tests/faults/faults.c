// A library to be preloaded (LD_PRELOAD): makes one call to the system fail, or ends the process
// there, as a full or broken disk, a kill or a power failure would.
//
//   FAULT_CALLS   names that are counted, separated by commas: open read write fsync rename link
//                 unlink truncate close mkdir flock; or "all"
//   FAULT_AT      which of them, from 1 on; 0 or none: only count
//   FAULT_HOW     an errno to fail with, or "kill"
//   FAULT_LASTS   set: all later ones fail, too
//   FAULT_BYTES   instead: after so many bytes written, every write fails with ENOSPC, half-written
//   FAULT_COUNT   file to which the number of calls counted is written at exit
//   FAULT_FOLDER  only files below this folder count (by name, or by what a descriptor stands for)
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <signal.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/types.h>
#include <sys/uio.h>
#include <unistd.h>

static atomic_long calls;
static atomic_long bytes;
static int wanted_ready;
static const char *wanted, *folder, *how;
static long at, most_bytes = -1;
static int lasts;

#define REAL(name, type, ...)                       \
  static type (*real)(__VA_ARGS__);                 \
  if (!real) real = (type(*)(__VA_ARGS__))dlsym(RTLD_NEXT, name)

static void read_wishes(void) {
  if (wanted_ready) return;
  wanted_ready = 1;
  wanted = getenv("FAULT_CALLS");
  folder = getenv("FAULT_FOLDER");
  how = getenv("FAULT_HOW");
  at = getenv("FAULT_AT") ? atol(getenv("FAULT_AT")) : 0;
  if (getenv("FAULT_BYTES")) most_bytes = atol(getenv("FAULT_BYTES"));
  lasts = getenv("FAULT_LASTS") != NULL;
}

__attribute__((destructor)) static void tell_count(void) {
  const char* file = getenv("FAULT_COUNT");
  if (!file) return;
  FILE* out = fopen(file, "w");
  if (out) {
    fprintf(out, "%ld\n", (long)calls);
    fclose(out);
  }
}

static int is_wanted(const char* call) {
  read_wishes();
  if (!wanted) return 0;
  if (strcmp(wanted, "all") == 0) return 1;
  const size_t length = strlen(call);
  for (const char* w = wanted; *w; w += strcspn(w, ","), w += *w == ',')
    if (strncmp(w, call, length) == 0 && (w[length] == ',' || !w[length])) return 1;
  return 0;
}

static int in_folder(const char* path) {
  if (!folder) return 1;
  char whole[PATH_MAX];
  if (path[0] == '/') return strncmp(path, folder, strlen(folder)) == 0;
  if (!getcwd(whole, sizeof whole) || strlen(whole) + strlen(path) + 2 > sizeof whole) return 0;
  strcat(strcat(whole, "/"), path);
  return strncmp(whole, folder, strlen(folder)) == 0;
}

static int descriptor_in_folder(int descriptor) {
  if (!folder) return 1;
  char name[64], target[PATH_MAX];
  snprintf(name, sizeof name, "/proc/self/fd/%d", descriptor);
  const ssize_t n = readlink(name, target, sizeof target - 1);
  if (n < 0) return 0;
  target[n] = 0;
  return strncmp(target, folder, strlen(folder)) == 0;
}

/// Counts a call; true if it is to fail, with errno set.
static int fails(const char* call, int here) {
  if (!here || !is_wanted(call)) return 0;
  const long n = ++calls;
  if (at == 0 || n < at || (n > at && !lasts)) return 0;
  if (how && strcmp(how, "kill") == 0) kill(getpid(), SIGKILL);
  errno = how ? atoi(how) : EIO;
  return 1;
}

/// How many bytes of a write still go through; -1: all.
static ssize_t room(int descriptor, size_t count) {
  read_wishes();
  if (most_bytes < 0 || !descriptor_in_folder(descriptor)) return -1;
  const long before = atomic_fetch_add(&bytes, (long)count);
  if (before + (long)count <= most_bytes) return -1;
  return before < most_bytes ? most_bytes - before : 0;
}

ssize_t write(int descriptor, const void* data, size_t count) {
  REAL("write", ssize_t, int, const void*, size_t);
  const int here = descriptor > 2 && descriptor_in_folder(descriptor);
  if (fails("write", here)) return -1;
  const ssize_t left = here ? room(descriptor, count) : -1;
  if (left == 0) return errno = ENOSPC, -1;
  return real(descriptor, data, left < 0 ? count : (size_t)left);
}

ssize_t pwrite64(int descriptor, const void* data, size_t count, off64_t offset) {
  REAL("pwrite64", ssize_t, int, const void*, size_t, off64_t);
  if (fails("write", descriptor_in_folder(descriptor))) return -1;
  const ssize_t left = room(descriptor, count);
  if (left == 0) return errno = ENOSPC, -1;
  return real(descriptor, data, left < 0 ? count : (size_t)left, offset);
}

ssize_t pwrite(int descriptor, const void* data, size_t count, off_t offset) {
  return pwrite64(descriptor, data, count, offset);
}

ssize_t writev(int descriptor, const struct iovec* parts, int count) {
  REAL("writev", ssize_t, int, const struct iovec*, int);
  if (fails("write", descriptor > 2 && descriptor_in_folder(descriptor))) return -1;
  return real(descriptor, parts, count);
}

#define WITH_DESCRIPTOR(name, call)                                    \
  int name(int descriptor) {                                           \
    REAL(#name, int, int);                                             \
    if (fails(call, descriptor_in_folder(descriptor))) {               \
      const int why = errno;                                           \
      if (strcmp(call, "close") == 0) real(descriptor);                \
      errno = why;                                                     \
      return -1;                                                       \
    }                                                                  \
    return real(descriptor);                                           \
  }
ssize_t pread64(int descriptor, void* data, size_t count, off64_t offset) {
  REAL("pread64", ssize_t, int, void*, size_t, off64_t);
  if (fails("read", descriptor_in_folder(descriptor))) return -1;
  return real(descriptor, data, count, offset);
}

ssize_t pread(int descriptor, void* data, size_t count, off_t offset) {
  return pread64(descriptor, data, count, offset);
}

ssize_t read(int descriptor, void* data, size_t count) {
  REAL("read", ssize_t, int, void*, size_t);
  if (fails("read", descriptor_in_folder(descriptor))) return -1;
  return real(descriptor, data, count);
}

WITH_DESCRIPTOR(fsync, "fsync")
WITH_DESCRIPTOR(fdatasync, "fsync")
WITH_DESCRIPTOR(close, "close")

#define WITH_LENGTH(name, type)                                        \
  int name(int descriptor, type length) {                              \
    REAL(#name, int, int, type);                                       \
    if (fails("truncate", descriptor_in_folder(descriptor))) return -1; \
    return real(descriptor, length);                                   \
  }
WITH_LENGTH(ftruncate, off_t)
WITH_LENGTH(ftruncate64, off64_t)

int flock(int descriptor, int operation) {
  REAL("flock", int, int, int);
  if (fails("flock", descriptor_in_folder(descriptor))) return -1;
  return real(descriptor, operation);
}

#define OPEN(name)                                              \
  int name(const char* path, int flags, ...) {                  \
    REAL(#name, int, const char*, int, ...);                    \
    va_list more;                                               \
    va_start(more, flags);                                      \
    const mode_t mode = va_arg(more, mode_t);                   \
    va_end(more);                                               \
    if (fails("open", in_folder(path))) return -1;              \
    return real(path, flags, mode);                             \
  }
OPEN(open)
OPEN(open64)

int rename(const char* from, const char* to) {
  REAL("rename", int, const char*, const char*);
  if (fails("rename", in_folder(to))) return -1;
  return real(from, to);
}

int linkat(int a, const char* from, int b, const char* to, int flags) {
  REAL("linkat", int, int, const char*, int, const char*, int);
  if (fails("link", in_folder(to))) return -1;
  return real(a, from, b, to, flags);
}

int unlink(const char* path) {
  REAL("unlink", int, const char*);
  if (fails("unlink", in_folder(path))) return -1;
  return real(path);
}

int mkdir(const char* path, mode_t mode) {
  REAL("mkdir", int, const char*, mode_t);
  if (fails("mkdir", in_folder(path))) return -1;
  return real(path, mode);
}
