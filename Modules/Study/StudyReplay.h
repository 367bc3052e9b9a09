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

/// Reads a recorded touch to be looked at. Throws InputError for what is none, has no ticks, or has
/// ticks that began before others that came before them.
PALPATESTUDY_EXPORT std::shared_ptr<const TouchRecording>
ReadReplay(const std::filesystem::path& file);

/// A recorded touch at a moment that can be moved and that goes on by itself while it is played.
/// Nothing is felt or computed again: what is read is what was. What a moment costs does not depend
/// on how long the recording is.
class PALPATESTUDY_EXPORT StudyReplay
{
public:
  /// What is shown with a moment: the ticks of so many seconds before it.
  static constexpr double SecondsBefore = 5.0;
  static constexpr double LeastSpeed = 0.01;
  static constexpr double LargestSpeed = 100.0;

  /// Stands at the first tick of a recording that ReadReplay read. Keeps the address of the clock.
  StudyReplay(std::filesystem::path file, std::shared_ptr<const TouchRecording> recording,
              Clock& clock);

  const std::filesystem::path& File() const { return this->Path; }
  const TouchRecording& Recording() const { return *this->Recorded; }
  std::shared_ptr<const TouchRecording> Shared() const { return this->Recorded; }
  double Duration() const; ///< s, from the first tick to the last
  double Position() const; ///< s since the first tick

  /// As near as the recording has it.
  void MoveTo(double seconds);
  bool IsPlaying() const { return this->Playing; }
  /// From the beginning where it stands at the end, where it stops by itself.
  void Play();
  void Pause();
  double Speed() const { return this->Rate; }
  /// Recorded seconds a second, within the bounds above.
  void SetSpeed(double speed);

  /// What was then: the last tick that had begun, and those since the last call, or of the
  /// SecondsBefore it after a leap. `labels` are those of the scene's structures, in their order.
  const StudyTouchReading& Poll(const std::vector<int>& labels);

private:
  std::size_t TickAt(double seconds) const;
  void HoldTo(double seconds);

  std::filesystem::path Path;
  std::shared_ptr<const TouchRecording> Recorded;
  Clock& Time;
  double Rate = 1.0;
  bool Playing = false;
  double Held = 0.0;      // s, where it stood
  std::int64_t Since = 0; // ns of the clock, then
  bool HasLeapt = true;
  std::size_t Last = 0; // tick, of the last reading
  StudyTouchReading Reading;
};
} // namespace palpate
