#pragma once

#include "TouchRecording.h"

#include <cstdint>
#include <fstream>
#include <string>

namespace palpate
{
/// Writes a session to a file while it goes on: somebody calls Drain often enough for the servo's
/// ring not to overflow. The file has its name only once Finish has written it whole; of a program
/// that dies the file ending with .part is left, up to the last 256 ticks.
class TouchRecorder
{
public:
  TouchRecorder() = default;
  TouchRecorder(const TouchRecorder&) = delete;
  TouchRecorder& operator=(const TouchRecorder&) = delete;
  /// Removes what was not finished.
  ~TouchRecorder();

  /// Begins a file. The servo has not ticked yet.
  Status Start(const std::string& path, const TouchSession& session);
  /// The next tick, for who fetches them from the servo and wants them too. Fails where ticks
  /// before it were lost or the file cannot be written.
  Status Take(const TouchState& state);
  /// Takes what the servo did since the last call.
  Status Drain(Servo& servo);
  /// The file under its name. The servo has stopped, and Drain was called since.
  Status Finish();

private:
  std::string Path;
  std::string TemporaryPath; // empty while there is no file
  std::ofstream File;
  std::uint64_t Written = 0;
};
} // namespace palpate
