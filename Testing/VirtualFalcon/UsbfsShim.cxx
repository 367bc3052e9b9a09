#include "UsbfsShim.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <cstring>
#include <dlfcn.h>
#include <fcntl.h>
#include <memory>
#include <unistd.h>

namespace palpate::test
{
namespace
{
// The libc function that this program overrides.
template <typename Function>
Function* Hidden(const char* name)
{
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

int CloseReally(int descriptor)
{
  static auto* const close = Hidden<int(int)>("close");
  return close(descriptor);
}

ssize_t ReadReally(int descriptor, void* bytes, size_t count)
{
  static auto* const read = Hidden<ssize_t(int, void*, size_t)>("read");
  return read(descriptor, bytes, count);
}

off_t SeekReally(int descriptor, off_t offset, int whence)
{
  static auto* const seek = Hidden<off_t(int, off_t, int)>("lseek");
  return seek(descriptor, offset, whence);
}

int ControlReally(int descriptor, unsigned long request, void* argument)
{
  static auto* const control = Hidden<int(int, unsigned long, ...)>("ioctl");
  return control(descriptor, request, argument);
}

// The other end of a descriptor from the shim.
class ShimFile
{
public:
  ShimFile(UsbfsFalcon& falcon, int readingEnd, int writingEnd)
      : Falcon(falcon), ReadingEnd(readingEnd),
        File(falcon.OpenFile([this, writingEnd](bool hasWork) { this->Show(hasWork, writingEnd); },
                             [this] { this->Break(); }))
  {
  }
  ~ShimFile()
  {
    this->Falcon.CloseFile(this->File);
    this->Break();
  }
  ShimFile(const ShimFile&) = delete;
  ShimFile& operator=(const ShimFile&) = delete;

  bool IsOpen() const { return this->File != nullptr; }

  int Control(unsigned long request, void* argument)
  {
    switch (request)
    {
    case USBDEVFS_SUBMITURB:
      return this->Falcon.Submit(*this->File, *static_cast<usbdevfs_urb*>(argument), argument);
    case USBDEVFS_REAPURBNDELAY:
      return this->Falcon.Reap(*this->File, *static_cast<void**>(argument));
    case USBDEVFS_DISCARDURB:
      return this->Falcon.Discard(*this->File, argument);
    default:
      return this->Falcon.Answer(*this->File, request, argument);
    }
  }

  ssize_t Read(void* bytes, std::size_t count)
  {
    const auto descriptors = this->Falcon.Descriptors().Bytes();
    const std::size_t length = std::min(count, descriptors.size() - this->Offset);
    std::memcpy(bytes, descriptors.data() + this->Offset, length);
    this->Offset += length;
    return static_cast<ssize_t>(length);
  }
  off_t Rewind()
  {
    this->Offset = 0;
    return 0;
  }

private:
  void Show(bool hasWork, int writingEnd)
  {
    char byte = 0;
    if (this->ReadingEnd >= 0)
    {
      static_cast<void>(hasWork ? ReadReally(this->ReadingEnd, &byte, 1)
                                : write(writingEnd, &byte, 1));
    }
  }
  void Break()
  {
    if (this->ReadingEnd >= 0)
    {
      CloseReally(this->ReadingEnd);
      this->ReadingEnd = -1;
    }
  }

  UsbfsFalcon& Falcon;
  int ReadingEnd;
  std::size_t Offset = 0; // of the next read
  UsbfsFile* File;        // last: its construction reports that there is no work
};

// Global, since functions that replace libc's have no other access to their data.
std::array<std::atomic<ShimFile*>, 1024> Shims{};

ShimFile* ShimOf(int descriptor)
{
  const auto index = static_cast<std::size_t>(descriptor);
  return descriptor >= 0 && index < Shims.size() ? Shims[index].load() : nullptr;
}

int WithErrno(int answer)
{
  if (answer >= 0)
  {
    return answer;
  }
  errno = -answer;
  return -1;
}
} // namespace

int UsbfsShim::Open()
{
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_NONBLOCK | O_CLOEXEC) != 0)
  {
    return -1;
  }
  fcntl(ends[1], F_SETPIPE_SZ, 1); // rounded up to a page, which is one slot
  auto file = std::make_unique<ShimFile>(this->Falcon, ends[0], ends[1]);
  if (!file->IsOpen() || static_cast<std::size_t>(ends[1]) >= Shims.size())
  {
    file.reset();
    CloseReally(ends[1]);
    return WithErrno(-ENODEV);
  }
  Shims[static_cast<std::size_t>(ends[1])] = file.release();
  return ends[1];
}
} // namespace palpate::test

using palpate::test::ShimFile;
using palpate::test::ShimOf;

extern "C"
{
  int ioctl(int descriptor, unsigned long request, ...) noexcept
  {
    va_list arguments;
    va_start(arguments, request);
    void* const argument = va_arg(arguments, void*);
    va_end(arguments);
    ShimFile* const file = ShimOf(descriptor);
    return file != nullptr ? palpate::test::WithErrno(file->Control(request, argument))
                           : palpate::test::ControlReally(descriptor, request, argument);
  }

  int close(int descriptor)
  {
    ShimFile* const file = ShimOf(descriptor);
    if (file != nullptr)
    {
      palpate::test::Shims[static_cast<std::size_t>(descriptor)] = nullptr;
      delete file;
    }
    return palpate::test::CloseReally(descriptor);
  }

  ssize_t read(int descriptor, void* bytes, size_t count)
  {
    ShimFile* const file = ShimOf(descriptor);
    return file != nullptr ? file->Read(bytes, count)
                           : palpate::test::ReadReally(descriptor, bytes, count);
  }

  off_t lseek(int descriptor, off_t offset, int whence) noexcept
  {
    ShimFile* const file = ShimOf(descriptor);
    return file != nullptr ? file->Rewind() : palpate::test::SeekReally(descriptor, offset, whence);
  }
}
