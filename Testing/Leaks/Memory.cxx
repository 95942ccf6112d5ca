// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Memory.h"

#include "vtkNBufferCuller.h"

#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <mutex>
#include <new>
#include <unordered_map>

#if defined(__SANITIZE_ADDRESS__)
// As in sanitizer/allocator_interface.h, which GCC's packages leave out.
extern "C" std::size_t __sanitizer_get_current_allocated_bytes();
#elif defined(__linux__) && defined(__GLIBC__)
#define MEMORY_TRACKS_MODULE
#include <link.h>
#include <malloc.h>
#endif

#ifdef MEMORY_TRACKS_MODULE
namespace
{
/// Memory for the table itself, which must not be noted in it.
template <typename T>
struct PlainAllocator
{
  using value_type = T;
  PlainAllocator() = default;
  template <typename U>
  PlainAllocator(const PlainAllocator<U>&)
  {
  }
  T* allocate(std::size_t n) { return static_cast<T*>(std::malloc(n * sizeof(T))); }
  void deallocate(T* block, std::size_t) { std::free(block); }
  bool operator==(const PlainAllocator&) const { return true; }
  bool operator!=(const PlainAllocator&) const { return false; }
};

class Table
{
public:
  void Add(void* block, std::size_t bytes)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Blocks[block] = bytes;
    this->Bytes += static_cast<long long>(bytes);
  }
  void Remove(void* block)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    const auto found = this->Blocks.find(block);
    if (found != this->Blocks.end())
    {
      this->Bytes -= static_cast<long long>(found->second);
      this->Blocks.erase(found);
    }
  }
  long long GetCount()
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    return static_cast<long long>(this->Blocks.size());
  }
  long long GetBytes()
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    return this->Bytes;
  }

private:
  std::mutex Mutex;
  std::unordered_map<void*, std::size_t, std::hash<void*>, std::equal_to<void*>,
    PlainAllocator<std::pair<void* const, std::size_t>>>
    Blocks;
  long long Bytes = 0;
};

Table& GetTable()
{
  // Never destroyed: blocks are freed until the very end of the process.
  alignas(Table) static unsigned char place[sizeof(Table)];
  static Table* const table = new (place) Table;
  return *table;
}

/// The executable segment of the file that `Address` lies in.
struct Code
{
  std::uintptr_t Address = 0;
  std::uintptr_t Begin = 0;
  std::uintptr_t End = 0;
};

int FindCode(dl_phdr_info* info, std::size_t, void* data)
{
  auto* code = static_cast<Code*>(data);
  for (int i = 0; i < info->dlpi_phnum; ++i)
  {
    const ElfW(Phdr)& segment = info->dlpi_phdr[i];
    const std::uintptr_t begin = info->dlpi_addr + segment.p_vaddr;
    if (segment.p_type == PT_LOAD && (segment.p_flags & PF_X) && code->Address >= begin &&
      code->Address < begin + segment.p_memsz)
    {
      code->Begin = begin;
      code->End = begin + segment.p_memsz;
      return 1;
    }
  }
  return 0;
}

Code FindCode(std::uintptr_t address)
{
  Code code;
  code.Address = address;
  dl_iterate_phdr(FindCode, &code);
  return code;
}

// Nothing is noted before these are set, when the program starts.
std::atomic<std::uintptr_t> ModuleBegin{ 0 };
std::atomic<std::uintptr_t> ModuleEnd{ 0 };

std::atomic<long long> Calls{ 0 };

const bool ModuleIsTracked = []
{
  // Tools such as valgrind put their own operator new in place of this one.
  const long long calls = Calls;
  operator delete(operator new(1));
  if (Calls == calls)
  {
    return false;
  }
  const Code module = FindCode(reinterpret_cast<std::uintptr_t>(&vtkNBufferCuller::New));
  const Code program = FindCode(reinterpret_cast<std::uintptr_t>(&GetTable));
  if (module.Begin == program.Begin)
  {
    return false;
  }
  ModuleEnd = module.End;
  ModuleBegin = module.Begin;
  return true;
}();

void* Allocate(std::size_t bytes, void* caller)
{
  ++Calls;
  void* block = std::malloc(bytes > 0 ? bytes : 1);
  const auto address = reinterpret_cast<std::uintptr_t>(caller);
  if (block && address >= ModuleBegin && address < ModuleEnd)
  {
    GetTable().Add(block, bytes);
  }
  return block;
}
}

void* operator new(std::size_t bytes)
{
  if (void* block = Allocate(bytes, __builtin_return_address(0)))
  {
    return block;
  }
  throw std::bad_alloc();
}

void* operator new(std::size_t bytes, const std::nothrow_t&) noexcept
{
  return Allocate(bytes, __builtin_return_address(0));
}

void operator delete(void* block) noexcept
{
  if (block && ModuleEnd != 0)
  {
    GetTable().Remove(block);
  }
  std::free(block);
}

void operator delete(void* block, std::size_t) noexcept
{
  operator delete(block);
}
#endif

namespace Memory
{
long long GetHeapBytes()
{
#if defined(__SANITIZE_ADDRESS__)
  return static_cast<long long>(__sanitizer_get_current_allocated_bytes());
#elif defined(__GLIBC__) && defined(__GLIBC_PREREQ)
#if __GLIBC_PREREQ(2, 33)
  const struct mallinfo2 info = mallinfo2();
  // 0 where another allocator stands in, such as valgrind's.
  return info.uordblks > 0 ? static_cast<long long>(info.uordblks + info.hblkhd) : -1;
#else
  return -1;
#endif
#else
  return -1;
#endif
}

long long GetModuleBlocks()
{
#ifdef MEMORY_TRACKS_MODULE
  return ModuleIsTracked ? GetTable().GetCount() : -1;
#else
  return -1;
#endif
}

long long GetModuleBytes()
{
#ifdef MEMORY_TRACKS_MODULE
  return ModuleIsTracked ? GetTable().GetBytes() : -1;
#else
  return -1;
#endif
}
}
