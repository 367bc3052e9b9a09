#include "TouchRecorder.h"

#include "TouchRecordingFormat.h"

#include <filesystem>
#include <system_error>

namespace palpate
{
namespace
{
using namespace TouchRecordingFormat;

template <std::size_t Count>
void WriteWords(std::ostream& file, const std::array<std::uint64_t, Count>& words)
{
  std::array<unsigned char, 8 * Count> bytes{};
  for (std::size_t i = 0; i < bytes.size(); ++i)
  {
    bytes[i] = static_cast<unsigned char>(words[i / 8] >> (8 * (i % 8)));
  }
  file.write(reinterpret_cast<const char*>(bytes.data()), bytes.size());
}
} // namespace

TouchRecorder::~TouchRecorder()
{
  if (!this->TemporaryPath.empty())
  {
    this->File.close();
    std::error_code ignored;
    std::filesystem::remove(this->TemporaryPath, ignored);
  }
}

Status TouchRecorder::Start(const std::string& path, const TouchSession& session)
{
  if (!this->TemporaryPath.empty())
  {
    return Status::Failure("A recording to " + this->Path + " is going on already.");
  }
  this->Path = path;
  this->File.open(path + ".part", std::ios::binary | std::ios::trunc);
  if (!this->File)
  {
    return Status::Failure(path + ".part cannot be written.");
  }
  this->TemporaryPath = path + ".part";
  this->Written = 0;
  this->File.write(Magic, MagicSize);
  WriteWords(this->File, Encode(session));
  return Status::Success();
}

Status TouchRecorder::Take(const TouchState& state)
{
  if (state.Tick.Number != this->Written)
  {
    return Status::Failure("Ticks before number " + std::to_string(state.Tick.Number) +
                           " were lost: the recording cannot be replayed.");
  }
  constexpr std::uint64_t TicksBetweenFlushes = 256;
  WriteWords(this->File, Encode(state));
  if (++this->Written % TicksBetweenFlushes == 0)
  {
    this->File.flush();
  }
  return this->File ? Status::Success()
                    : Status::Failure(this->TemporaryPath + " cannot be written any further.");
}

Status TouchRecorder::Drain(Servo& servo)
{
  Status status = Status::Success();
  for (TouchState state; status.IsOk() && servo.PopRecorded(state);)
  {
    status = this->Take(state);
  }
  return status;
}

Status TouchRecorder::Finish()
{
  if (this->TemporaryPath.empty())
  {
    return Status::Failure("There is no recording to be finished.");
  }
  this->File.close();
  if (!this->File)
  {
    return Status::Failure(this->TemporaryPath + " cannot be written.");
  }
  std::error_code error;
  std::filesystem::rename(this->TemporaryPath, this->Path, error);
  if (error)
  {
    return Status::Failure(this->Path + " cannot be written (" + error.message() + ").");
  }
  this->TemporaryPath.clear();
  return Status::Success();
}
} // namespace palpate
