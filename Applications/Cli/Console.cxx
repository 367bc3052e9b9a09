#include "Console.h"

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
  if (!this->Terminal || this->Quiet || now - this->LastDraw < DrawInterval)
  {
    return false;
  }
  this->LastDraw = now;
  return true;
}

void Console::Progress(double fraction, const std::string& stage)
{
  if (this->IsTimeToDraw())
  {
    this->Draw(std::isfinite(fraction) ? std::clamp(fraction, 0.0, 1.0) : 0.0, stage,
               SecondsBetween(this->Start, this->LastDraw));
  }
}

void Console::Live(const std::string& line)
{
  if (this->IsTimeToDraw())
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
