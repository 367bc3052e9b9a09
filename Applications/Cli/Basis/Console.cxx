#include "Console.h"

#include "DecimalText.h"
#include "ScreenText.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ostream>

namespace palpate::cli
{
namespace
{
constexpr std::chrono::milliseconds DrawInterval(100);
constexpr int BarWidth = 24;
// Earlier estimates of the time left would be guesses.
constexpr double FirstEstimateSeconds = 1.0;

double SecondsBetween(std::chrono::steady_clock::time_point first,
                      std::chrono::steady_clock::time_point last)
{
  return std::chrono::duration<double>(last - first).count();
}

// Slicer looks for the next "<" after a tag's text.
std::string WithoutTags(const std::string& text)
{
  std::string plain = Printable(text);
  std::replace(plain.begin(), plain.end(), '<', '(');
  std::replace(plain.begin(), plain.end(), '>', ')');
  return plain;
}

std::string MinutesAndSeconds(double seconds)
{
  const long whole = std::lround(std::min(seconds, 359999.0));
  char text[32];
  std::snprintf(text, sizeof text, "%ld:%02ld", whole / 60, whole % 60);
  return text;
}
} // namespace

Console::Console(std::ostream& output, std::ostream& errors, bool errorsAreTerminal)
    : Out(output), Errors(errors), Terminal(errorsAreTerminal),
      Start(std::chrono::steady_clock::now()), LastDraw(Start - DrawInterval)
{
}

void Console::Note(const std::string& message)
{
  if (!this->Quiet)
  {
    this->Wipe();
    this->Errors << Printable(message) << '\n' << std::flush;
  }
}

void Console::Error(const std::string& message)
{
  this->Wipe();
  // Pending output comes first, in the order that the user expects.
  this->Out << std::flush;
  this->Errors << "palpate: " << Printable(message) << '\n' << std::flush;
}

void Console::Relay(const std::string& results, const std::string& messages)
{
  this->Wipe();
  this->Out << results << std::flush;
  this->Errors << messages << std::flush;
}

bool Console::IsTimeToDraw()
{
  const auto now = std::chrono::steady_clock::now();
  const bool isShown = this->Terminal || !this->SlicerName.empty();
  if (!isShown || this->Quiet || now - this->LastDraw < DrawInterval)
  {
    return false;
  }
  this->LastDraw = now;
  return true;
}

void Console::Progress(double fraction, const std::string& stage)
{
  if (!this->IsTimeToDraw())
  {
    return;
  }
  const double shown = std::isfinite(fraction) ? std::clamp(fraction, 0.0, 1.0) : 0.0;
  if (!this->SlicerName.empty())
  {
    this->WriteForSlicer(shown, stage);
    return;
  }
  this->Draw(shown, stage, SecondsBetween(this->Start, this->LastDraw));
}

void Console::StartSlicerProgress(const std::string& name)
{
  if (!this->Quiet)
  {
    this->SlicerName = name;
    this->SlicerStart = std::chrono::steady_clock::now();
    this->Out << "<filter-start><filter-name>" << WithoutTags(name)
              << "</filter-name></filter-start>\n"
              << std::flush;
  }
}

void Console::WriteForSlicer(double fraction, const std::string& stage)
{
  if (stage != this->SlicerStage)
  {
    this->SlicerStage = stage;
    this->Out << "<filter-comment>" << WithoutTags(stage) << "</filter-comment>\n";
  }
  this->Out << "<filter-progress>" << FixedText(fraction, 3) << "</filter-progress>\n"
            << std::flush;
}

void Console::EndSlicerProgress()
{
  if (!this->SlicerName.empty())
  {
    const double seconds = SecondsBetween(this->SlicerStart, std::chrono::steady_clock::now());
    this->Out << "<filter-end><filter-name>" << WithoutTags(this->SlicerName)
              << "</filter-name><filter-time>" << FixedText(seconds, 1)
              << "</filter-time></filter-end>\n"
              << std::flush;
    this->SlicerName.clear();
  }
}

void Console::Live(const std::string& line)
{
  if (this->SlicerName.empty() && this->IsTimeToDraw())
  {
    this->Errors << "\r\x1b[K" << Printable(line) << std::flush;
    this->Drawn = true;
  }
}

void Console::EndProgress()
{
  this->Wipe();
  this->Start = std::chrono::steady_clock::now();
  this->LastDraw = this->Start - DrawInterval;
}

void Console::Draw(double fraction, const std::string& stage, double elapsedSeconds)
{
  const int filled = static_cast<int>(fraction * BarWidth);
  char percent[16];
  std::snprintf(percent, sizeof percent, "%3.0f %%", 100.0 * fraction);
  this->Errors << "\r\x1b[K[" << std::string(static_cast<std::size_t>(filled), '#')
               << std::string(static_cast<std::size_t>(BarWidth - filled), '.') << "] " << percent
               << "  " << Printable(stage);
  if (elapsedSeconds >= FirstEstimateSeconds && fraction > 0.0)
  {
    this->Errors << "  " << MinutesAndSeconds(elapsedSeconds * (1.0 - fraction) / fraction)
                 << " left";
  }
  this->Errors << std::flush;
  this->Drawn = true;
}

void Console::Wipe()
{
  if (this->Drawn)
  {
    this->Errors << "\r\x1b[K" << std::flush;
    this->Drawn = false;
  }
}
} // namespace palpate::cli
