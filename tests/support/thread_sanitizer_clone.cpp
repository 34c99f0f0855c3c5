// QProcess starts a program by clone(), whose child shares its parent's memory until it executes another
// program (CLONE_VM | CLONE_VFORK). The thread sanitizer's clone assumes separate memory and ends the program
// in a failed internal check; these tests therefore call the C library's clone.

#include <sched.h>

#include <cstdarg>

extern "C" {

int __clone(int (*child)(void*), void* stack, int flags, void* argument, ...);

int clone(int (*child)(void*), void* stack, int flags, void* argument, ...) noexcept {
  va_list rest;
  va_start(rest, argument);
  auto* const parentId = va_arg(rest, pid_t*);
  void* const storage = va_arg(rest, void*);
  auto* const childId = va_arg(rest, pid_t*);
  va_end(rest);
  return __clone(child, stack, flags, argument, parentId, storage, childId);
}
}
