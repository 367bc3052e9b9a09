#pragma once

#include "BackgroundWriter.h"
#include "TemporaryFile.h"
#include "TouchRecording.h"

#include <cstdint>
#include <memory>
#include <string>

namespace palpate
{
/// Writes a session to a file while it goes on: somebody calls Drain often enough for the servo's
/// ring not to overflow. The bytes go to the disk on a thread of their own, and are synchronised
/// with it every two seconds. The file has its name only once Finish has written it whole. Until
/// then, and for good where a disk fills up, stalls, or the program dies, it is
/// `<name>.<number>.part`, which ReadTouchRecording reads too. One recorder at a time writes to a
/// name, over all programs.
class TouchRecorder
{
public:
  TouchRecorder() : TouchRecorder(BackgroundWriter::Limits()) {}
  explicit TouchRecorder(BackgroundWriter::Limits limits) : Limits(limits) {}
  TouchRecorder(const TouchRecorder&) = delete;
  TouchRecorder& operator=(const TouchRecorder&) = delete;
  /// Keeps what was not finished as a .part, unless no tick was taken.
  ~TouchRecorder();

  /// Begins a file. The servo has not ticked yet. Fails where the file cannot be written, or
  /// another recorder writes to `path`.
  Status Start(const std::string& path, const TouchSession& session);
  /// The next tick, for who fetches them from the servo and wants them too. Fails where ticks
  /// before it were lost or the file cannot be written; the recording has ended then, and the
  /// message says how much of it is kept, and where.
  Status Take(const TouchState& state);
  /// Takes what the servo did since the last call.
  Status Drain(Servo& servo);
  /// The file under its name. The servo has stopped, and Drain was called since. Fails as Take.
  Status Finish();

private:
  Status Flush();
  Status End(const std::string& reason);
  std::uint64_t TicksInFile();

  BackgroundWriter::Limits Limits;
  std::string Path;
  double Rate = 0.0;                   ///< Hz
  std::unique_ptr<TemporaryFile> File; ///< none: nothing is recorded
  std::unique_ptr<BackgroundWriter> Writer;
  std::string Pending; ///< ticks that the writer does not have yet
  std::uint64_t Taken = 0;
};
} // namespace palpate
