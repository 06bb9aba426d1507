// SPDX-License-Identifier: GPL-3.0-or-later
#include "Common/GmpMemory.h"

#include <cstdlib>
#include <gmp.h>
#include <new>

// GMP's default allocation function; its headers do not declare it.
extern "C" void* __gmp_default_allocate(std::size_t);

namespace insideout
{
namespace
{
void* OrThrow(void* memory)
{
  if (!memory)
  {
    throw std::bad_alloc();
  }
  return memory;
}

extern "C" void* AllocateForGmp(std::size_t size)
{
  return OrThrow(std::malloc(size));
}

extern "C" void* ReallocateForGmp(void* memory, std::size_t, std::size_t size)
{
  return OrThrow(std::realloc(memory, size));
}

extern "C" void FreeForGmp(void* memory, std::size_t)
{
  std::free(memory);
}
} // namespace

bool ThrowWhereGmpGetsNoMemory()
{
  void* (*allocate)(std::size_t) = nullptr;
  mp_get_memory_functions(&allocate, nullptr, nullptr);
  if (allocate == __gmp_default_allocate)
  {
    mp_set_memory_functions(AllocateForGmp, ReallocateForGmp, FreeForGmp);
    return true;
  }
  return allocate == AllocateForGmp;
}
} // namespace insideout
