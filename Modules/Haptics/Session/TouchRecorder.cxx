#include "TouchRecorder.h"

#include "TouchRecordingFormat.h"

#include <array>
#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <filesystem>
#include <sys/file.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace palpate
{
namespace
{
using namespace TouchRecordingFormat;

constexpr std::uint64_t TicksBetweenFlushes = 256;
constexpr std::uint64_t HeadBytes = MagicSize + 8 * SessionWords;
constexpr std::uint64_t TickBytes = 8 * TickWords;
constexpr const char* PartEnding = ".part";

template <std::size_t Count>
void AppendWords(std::string& bytes, const std::array<std::uint64_t, Count>& words)
{
  static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__);
  bytes.append(reinterpret_cast<const char*>(words.data()), sizeof(words));
}

/// An open file, closed with the object.
class OpenFile
{
public:
  explicit OpenFile(int file) : File(file) {}
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  ~OpenFile()
  {
    if (this->File >= 0)
    {
      close(this->File);
    }
  }
  int Number() const { return this->File; }

private:
  int File;
};

// With a duplicated descriptor, since a stalled disk uses it beyond the recorder's lifetime.
BackgroundWriter::Target TargetOf(int descriptor)
{
  const auto file = std::make_shared<OpenFile>(fcntl(descriptor, F_DUPFD_CLOEXEC, 0));
  const auto write = [file](std::string_view bytes)
  {
    while (!bytes.empty())
    {
      const ssize_t count = ::write(file->Number(), bytes.data(), bytes.size());
      if (count < 0 && errno != EINTR)
      {
        return Status::Failure(std::generic_category().message(errno));
      }
      bytes.remove_prefix(count < 0 ? 0 : static_cast<std::size_t>(count));
    }
    return Status::Success();
  };
  return {write, [file] { static_cast<void>(fdatasync(file->Number())); }};
}

// Prefix of the temporary names of a recording; file names have at most 255 bytes.
std::string PartPrefix(const std::filesystem::path& target)
{
  constexpr std::size_t Longest = 230;
  return target.filename().string().substr(0, Longest) + ".";
}

// Whether another recorder, of this or another program, holds a part of the same recording. On file
// systems without locks the recordings are separate, and the last one finished gets the name.
bool IsRecordedByAnother(const TemporaryFile& own)
{
  const std::string prefix = PartPrefix(own.Target());
  std::error_code error;
  for (std::filesystem::directory_iterator entry(own.Path().parent_path(), error), end;
       !error && entry != end; entry.increment(error))
  {
    const std::string name = entry->path().filename().string();
    if (name.compare(0, prefix.size(), prefix) != 0 || entry->path().extension() != PartEnding ||
        entry->path() == own.Path())
    {
      continue;
    }
    const OpenFile part(
        open(entry->path().c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK));
    if (part.Number() >= 0 && flock(part.Number(), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
    {
      return true;
    }
  }
  return false;
}

// Creates the file of a recording and holds its lock, at the latest until the program ends.
Status Claim(const std::filesystem::path& path, TemporaryFile& file)
{
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
  // Serialises two recorders that start at the same time.
  const OpenFile turn(open(folder.c_str(), O_RDONLY | O_CLOEXEC | O_DIRECTORY));
  static_cast<void>(turn.Number() >= 0 && flock(turn.Number(), LOCK_EX) == 0);
  const Status status = file.Create(path, PartPrefix(path), PartEnding);
  if (!status.IsOk())
  {
    return Status::Failure(path.string() + " cannot be written: " + status.Message() +
                           "; choose another output.");
  }
  static_cast<void>(flock(file.Descriptor(), LOCK_EX | LOCK_NB));
  return IsRecordedByAnother(file)
             ? Status::Failure(path.string() +
                               " is already being recorded; end that session or choose another "
                               "output.")
             : Status::Success();
}
} // namespace

TouchRecorder::~TouchRecorder()
{
  if (this->File != nullptr && this->Taken > 0)
  {
    static_cast<void>(this->End("not finished"));
  }
}

Status TouchRecorder::Start(const std::string& path, const RecordedSession& session)
{
  if (this->File != nullptr)
  {
    return Status::Failure("A recording to " + this->Path + " is already running.");
  }
  auto file = std::make_unique<TemporaryFile>();
  if (Status status = Claim(path, *file); !status.IsOk())
  {
    return status;
  }
  this->Path = path;
  this->Rate = session.Settings.Rate;
  this->File = std::move(file);
  this->Writer =
      std::make_unique<BackgroundWriter>(TargetOf(this->File->Descriptor()), this->Limits);
  this->Taken = 0;
  this->Pending.assign(Magic, MagicSize);
  AppendWords(this->Pending, Encode(session));
  return Status::Success();
}

Status TouchRecorder::Take(const TouchState& state)
{
  if (this->File == nullptr)
  {
    return Status::Failure("No recording is running.");
  }
  if (state.Tick.Number != this->Taken)
  {
    return this->End("the ticks before number " + std::to_string(state.Tick.Number) +
                     " were lost: they were not fetched in time");
  }
  AppendWords(this->Pending, Encode(state));
  return ++this->Taken % TicksBetweenFlushes == 0 ? this->Flush() : Status::Success();
}

Status TouchRecorder::Flush()
{
  const Status status = this->Writer->Append(this->Pending);
  this->Pending.clear();
  return status.IsOk() ? status : this->End(status.Message());
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

// On a stalled disk, the number of ticks known to be written; otherwise the number in the file,
// after removing a partial tick, which a full disk leaves.
std::uint64_t TouchRecorder::TicksInFile()
{
  std::uint64_t bytes = this->Writer->WrittenBytes();
  struct stat file = {};
  const bool isAnswering = !this->Writer->HasStalled();
  if (isAnswering && fstat(this->File->Descriptor(), &file) == 0)
  {
    bytes = static_cast<std::uint64_t>(file.st_size);
  }
  const std::uint64_t ticks = bytes < HeadBytes ? 0 : (bytes - HeadBytes) / TickBytes;
  if (isAnswering)
  {
    // If this fails, the reader ignores the partial tick.
    static_cast<void>(
        ftruncate(this->File->Descriptor(), static_cast<off_t>(HeadBytes + ticks * TickBytes)));
  }
  return ticks;
}

// Ends the recording, keeping the ticks so far.
Status TouchRecorder::End(const std::string& reason)
{
  static_cast<void>(this->Writer->Append(this->Pending));
  static_cast<void>(this->Writer->Finish());
  this->Pending.clear();
  const std::uint64_t ticks = this->TicksInFile();
  const std::filesystem::path part = this->File->Path();
  if (ticks > 0)
  {
    this->File->Keep();
  }
  this->Writer.reset();
  this->File.reset();
  if (ticks == 0)
  {
    return Status::Failure(this->Path + " could not be recorded: " + reason +
                           "; choose another output.");
  }
  std::array<char, 64> seconds{};
  std::snprintf(seconds.data(), seconds.size(), "%.3f s (%llu ticks)",
                static_cast<double>(ticks) / this->Rate, static_cast<unsigned long long>(ticks));
  return Status::Failure("The recording ended after " + std::string(seconds.data()) + ": " +
                         reason + "; they are kept as " + part.string() +
                         ", which can be read like a recording.");
}

Status TouchRecorder::Finish()
{
  if (this->File == nullptr)
  {
    return Status::Failure("No recording is running.");
  }
  Status status = this->Writer->Append(this->Pending);
  this->Pending.clear();
  status = status.IsOk() ? this->Writer->Finish() : status;
  status = status.IsOk() ? this->File->Publish() : status;
  if (!status.IsOk())
  {
    return this->End(status.Message());
  }
  this->Writer.reset();
  this->File.reset();
  return status;
}
} // namespace palpate
