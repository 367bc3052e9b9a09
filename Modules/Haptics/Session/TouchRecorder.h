#pragma once

#include "BackgroundWriter.h"
#include "TemporaryFile.h"
#include "TouchRecording.h"

#include <cstdint>
#include <memory>
#include <string>

namespace palpate
{
/// Writes a session to a file while it runs: Drain must be called often enough for the servo's ring
/// not to overflow. A thread of its own writes the bytes to the disk and synchronises every two
/// seconds. The file gets its name only once Finish has written it completely. Until then, and
/// permanently if a disk fills up or stalls, or the program dies, it is `<name>.<number>.part`,
/// which ReadTouchRecording reads too. Only one recorder at a time writes to a name, over all
/// programs.
class TouchRecorder
{
public:
  TouchRecorder() : TouchRecorder(BackgroundWriter::Limits()) {}
  explicit TouchRecorder(BackgroundWriter::Limits limits) : Limits(limits) {}
  TouchRecorder(const TouchRecorder&) = delete;
  TouchRecorder& operator=(const TouchRecorder&) = delete;
  /// Keeps an unfinished recording as a .part, unless it has no ticks.
  ~TouchRecorder();

  /// Starts a file. The servo must not have ticked yet. Fails if the file cannot be written, or
  /// another recorder writes to `path`.
  Status Start(const std::string& path, const RecordedSession& session);
  /// Adds the next tick, for callers that fetch ticks from the servo themselves. Fails if earlier
  /// ticks were lost or the file cannot be written; the recording has then ended, and the message
  /// tells how much of it is kept, and where.
  Status Take(const TouchState& state);
  /// Adds the servo's ticks since the last call.
  Status Drain(Servo& servo);
  /// Gives the file its name. Call after the servo has stopped and a last Drain. Fails as Take.
  Status Finish();

private:
  Status Flush();
  Status End(const std::string& reason);
  std::uint64_t TicksInFile();

  BackgroundWriter::Limits Limits;
  std::string Path;
  double Rate = 0.0;                   ///< Hz
  std::unique_ptr<TemporaryFile> File; ///< null: not recording
  std::unique_ptr<BackgroundWriter> Writer;
  std::string Pending; ///< ticks not yet passed to the writer
  std::uint64_t Taken = 0;
};
} // namespace palpate
