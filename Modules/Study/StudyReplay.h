#pragma once

#include "Clock.h"
#include "PalpateStudyModule.h"
#include "StudyTouch.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

namespace palpate
{
struct TouchRecording;

/// Reads a recorded touch for replay. Throws InputError if the file is not a recording, has no
/// ticks, or has ticks out of order.
PALPATESTUDY_EXPORT std::shared_ptr<const TouchRecording>
ReadReplay(const std::filesystem::path& file);

/// Player of a recorded touch: shows the recorded ticks at a position that can be moved or played.
/// Nothing is computed again and no force is applied. The time per reading does not depend on the
/// length of the recording.
class PALPATESTUDY_EXPORT StudyReplay
{
public:
  /// Seconds of ticks that are shown before the current position.
  static constexpr double SecondsBefore = 5.0;
  static constexpr double LeastSpeed = 0.01;
  static constexpr double LargestSpeed = 100.0;

  /// Starts at the first tick of a recording read by ReadReplay. Keeps the address of the clock.
  StudyReplay(std::filesystem::path file, std::shared_ptr<const TouchRecording> recording,
              Clock& clock);

  const std::filesystem::path& File() const { return this->Path; }
  const TouchRecording& Recording() const { return *this->Recorded; }
  std::shared_ptr<const TouchRecording> Shared() const { return this->Recorded; }
  double Duration() const; ///< s, from the first tick to the last
  double Position() const; ///< s since the first tick

  /// Clamped to the recording.
  void MoveTo(double seconds);
  bool IsPlaying() const { return this->Playing; }
  /// Restarts from the beginning if at the end; stops at the end.
  void Play();
  void Pause();
  double Speed() const { return this->Rate; }
  /// Recorded seconds per second, within the limits above.
  void SetSpeed(double speed);

  /// The state at the current position: the last tick that had begun, and the ticks since the last
  /// call, or those of the SecondsBefore it after a jump. `labels` are those of the scene's
  /// structures, in their order.
  const StudyTouchReading& Poll(const std::vector<int>& labels);

private:
  std::size_t TickAt(double seconds) const;
  void HoldTo(double seconds);

  std::filesystem::path Path;
  std::shared_ptr<const TouchRecording> Recorded;
  Clock& Time;
  double Rate = 1.0;
  bool Playing = false;
  double Held = 0.0;      // s, position at Since
  std::int64_t Since = 0; // ns of the clock
  bool HasLeapt = true;
  std::size_t Last = 0; // tick, of the last reading
  StudyTouchReading Reading;
};
} // namespace palpate
