#pragma once

#include <chrono>
#include <iosfwd>
#include <string>

namespace palpate::cli
{
/// Where a command writes: results to the output stream, messages and progress to the error stream.
/// Progress is drawn only if the error stream is a terminal, or written on the output stream in the
/// format of 3D Slicer.
class Console
{
public:
  Console(std::ostream& output, std::ostream& errors, bool errorsAreTerminal);

  /// Quiet: no notes and no progress; results and errors stay.
  void SetQuiet(bool quiet) { this->Quiet = quiet; }
  bool IsQuiet() const { return this->Quiet; }

  /// Results, for scripts to read.
  std::ostream& Output() { return this->Out; }
  /// A note: one line on the error stream, even if names from files contain line breaks.
  void Note(const std::string& message);
  /// An error: one line "palpate: message" on the error stream, likewise.
  void Error(const std::string& message);
  /// What another console wrote: results and complete lines of messages.
  void Relay(const std::string& results, const std::string& messages);
  /// Draws `stage` with a bar and the time left; fraction in 0..1. Cheap enough to call often.
  void Progress(double fraction, const std::string& stage);
  /// Draws a line that the next one replaces, like progress.
  void Live(const std::string& line);
  /// From here on, writes progress for 3D Slicer (unless quiet), which shows the name until the
  /// first stage.
  void StartSlicerProgress(const std::string& name);
  /// Tells it that the work has ended; without a start, does nothing.
  void EndSlicerProgress();
  /// Clears the progress line and starts the clock of the next one.
  void EndProgress();

private:
  bool IsTimeToDraw();
  void Draw(double fraction, const std::string& stage, double elapsedSeconds);
  void WriteForSlicer(double fraction, const std::string& stage);
  void Wipe();

  std::ostream& Out;
  std::ostream& Errors;
  bool Terminal;
  bool Quiet = false;
  bool Drawn = false;
  std::string SlicerName; ///< of the work that 3D Slicer runs; empty if it does not
  std::string SlicerStage;
  std::chrono::steady_clock::time_point SlicerStart;
  std::chrono::steady_clock::time_point Start;
  std::chrono::steady_clock::time_point LastDraw;
};
} // namespace palpate::cli
