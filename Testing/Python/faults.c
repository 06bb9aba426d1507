/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A disk that fails when it is told to. Preloaded (LD_PRELOAD), it looks at what the process does with
 * files below a folder, as the environment says at that moment:
 *
 *   INSIDEOUT_FAULT  "CALL K ERROR FOLDER": of the calls of open (to create a file), write, fsync, close
 *                    or rename the K-th, from 1 on, fails with this number of errno; "CALL K -SIGNAL
 *                    FOLDER": the process gets this signal before it; and where the signal is above
 *                    HANGS, by so much, the call never ends. A new text counts anew.
 *   INSIDEOUT_PIECE  at most as many bytes are written there at once, so that a small file takes many
 *                    writes.
 */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/types.h>
#include <unistd.h>

enum
{
  HANGS = 100
};

static int is_below(const char* folder, const char* path)
{
  const size_t length = strlen(folder);
  return strncmp(path, folder, length) == 0 && path[length] == '/';
}

/* What INSIDEOUT_FAULT says. */
struct fault
{
  char call[16];
  long which;
  int error;
  char folder[3000];
};

/* Whether there is a fault for what is done with this path. */
static int concerns(const char* path, struct fault* fault)
{
  const char* text = getenv("INSIDEOUT_FAULT");
  return text &&
    sscanf(text, "%15s %ld %d %2999s", fault->call, &fault->which, &fault->error, fault->folder) ==
    4 &&
    is_below(fault->folder, path);
}

/* Whether this call of `name` on `path` fails; a signal is sent here. */
static int fails(const char* name, const char* path)
{
  static char last[4096];
  static long count;
  struct fault fault;
  if (!concerns(path, &fault))
  {
    return 0;
  }
  const char* text = getenv("INSIDEOUT_FAULT");
  if (strcmp(text, last) != 0)
  {
    snprintf(last, sizeof(last), "%s", text);
    count = 0;
  }
  if (strcmp(fault.call, name) != 0 || ++count != fault.which)
  {
    return 0;
  }
  if (fault.error < 0)
  {
    kill(getpid(), -fault.error % HANGS);
    while (-fault.error > HANGS)
    {
      pause();
    }
    return 0;
  }
  errno = fault.error;
  return 1;
}

/* The file behind a descriptor; an empty text where it has no name. */
static const char* path_of(int descriptor)
{
  static char path[4096];
  char link[64];
  snprintf(link, sizeof(link), "/proc/self/fd/%d", descriptor);
  const ssize_t length = readlink(link, path, sizeof(path) - 1);
  path[length < 0 ? 0 : length] = '\0';
  return path;
}

typedef int (*open_function)(const char*, int, ...);

static int open_by(const char* name, const char* path, int flags, mode_t mode)
{
  if ((flags & O_CREAT) && fails("open", path))
  {
    return -1;
  }
  return ((open_function)dlsym(RTLD_NEXT, name))(path, flags, mode);
}

int open(const char* path, int flags, ...)
{
  va_list arguments;
  va_start(arguments, flags);
  const mode_t mode = va_arg(arguments, mode_t);
  va_end(arguments);
  return open_by("open", path, flags, mode);
}

int open64(const char* path, int flags, ...)
{
  va_list arguments;
  va_start(arguments, flags);
  const mode_t mode = va_arg(arguments, mode_t);
  va_end(arguments);
  return open_by("open64", path, flags, mode);
}

ssize_t write(int descriptor, const void* bytes, size_t length)
{
  const char* piece = getenv("INSIDEOUT_PIECE");
  struct fault fault;
  if (fails("write", path_of(descriptor)))
  {
    return -1;
  }
  if (piece && concerns(path_of(descriptor), &fault) && length > (size_t)atol(piece))
  {
    length = (size_t)atol(piece);
  }
  return ((ssize_t(*)(int, const void*, size_t))dlsym(RTLD_NEXT, "write"))(
    descriptor, bytes, length);
}

int fsync(int descriptor)
{
  return fails("fsync", path_of(descriptor))
    ? -1
    : ((int (*)(int))dlsym(RTLD_NEXT, "fsync"))(descriptor);
}

int close(int descriptor)
{
  const int failed = fails("close", path_of(descriptor));
  const int error = errno;
  const int result = ((int (*)(int))dlsym(RTLD_NEXT, "close"))(descriptor);
  errno = failed ? error : errno;
  return failed ? -1 : result;
}

int rename(const char* from, const char* to)
{
  return fails("rename", to)
    ? -1
    : ((int (*)(const char*, const char*))dlsym(RTLD_NEXT, "rename"))(from, to);
}
