#include "HdfTransform.h"

#include "AtomicFile.h"
#include "ChildProgram.h"
#include "FrameExchange.h"
#include "Refusal.h"
#include "WholeFile.h"

#include <string>
#include <unistd.h>

namespace palpate
{
namespace
{
constexpr const char* Helper = "palpate-transform-hdf5";
constexpr std::uintmax_t LargestHdf = 1U << 20U; // bytes

// The helper's process, which ends with its work.
class HdfHelper
{
public:
  HdfHelper(const std::string& action, const std::filesystem::path& file)
  {
    int sockets[2] = {-1, -1};
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, sockets) == 0)
    {
      this->Process =
          StartChildProgram(Helper, {action, std::filesystem::absolute(file).string()}, sockets[1]);
      close(sockets[1]);
      this->Socket = sockets[0];
    }
    if (this->Process < 0)
    {
      this->End();
      Refuse(file, std::string("is in HDF5, but ") + Helper + " cannot be started for it",
             "install that program next to palpate or on the PATH");
    }
  }
  HdfHelper(const HdfHelper&) = delete;
  HdfHelper& operator=(const HdfHelper&) = delete;
  ~HdfHelper() { this->End(); }

  bool Send(const MapRows& map) { return SendAll(this->Socket, map.data(), sizeof(map)); }
  bool Receive(MapRows& map) { return ReceiveAll(this->Socket, map.data(), sizeof(map)); }
  bool IsDone()
  {
    char done = 0;
    return ReceiveAll(this->Socket, &done, 1);
  }

private:
  void End() noexcept
  {
    if (this->Socket >= 0)
    {
      close(this->Socket);
    }
    if (this->Process >= 0)
    {
      WaitForChildProgram(this->Process);
    }
  }

  int Socket = -1;
  pid_t Process = -1;
};
} // namespace

MapRows ReadHdfTransform(const std::filesystem::path& file)
{
  if (InputFileSize(file) > LargestHdf)
  {
    Refuse(file, "is larger than a linear transform in HDF5",
           "write one rigid, similarity or affine transform, without a grid");
  }
  HdfHelper helper("read", file);
  MapRows map{};
  if (!helper.Receive(map) || !helper.IsDone())
  {
    Refuse(file, "is damaged, or has no linear transform of three dimensions, or several of them",
           "write one rigid, similarity or affine transform");
  }
  return map;
}

void WriteHdfTransform(const std::filesystem::path& file, const MapRows& map)
{
  AtomicFile written(file);
  HdfHelper helper("write", written.TemporaryPath());
  if (!helper.Send(map) || !helper.IsDone())
  {
    Refuse(file, "cannot be written", "choose another place, or write it as text (.tfm)");
  }
  written.Commit();
}
} // namespace palpate
