// palpate-falcon-guard: waits for the end of the process that drives a Falcon, or for its signal,
// and then sends 0 N to the board (FalconGuard). Its standard input is connected to that process;
// its argument is the Falcon's USB port.
#include "FalconGuard.h"
#include "LibusbFalconStop.h"

#include <cerrno>
#include <chrono>
#include <poll.h>
#include <unistd.h>

namespace
{
constexpr std::chrono::seconds Patience(60); // until a device that left the bus is back
constexpr int Interval = 20;                 // ms

enum class Word
{
  Nothing,
  Stop,
  Quit,
  End
};

Word Read()
{
  char word = 0;
  ssize_t count = 0;
  do
  {
    count = read(STDIN_FILENO, &word, 1);
  } while (count < 0 && errno == EINTR);
  return count <= 0 ? Word::End : word == palpate::FalconGuard::Quit ? Word::Quit : Word::Stop;
}

// Waits for an interval; no word arrives once the input has ended.
Word Wait(bool hasEnded)
{
  pollfd input{hasEnded ? -1 : STDIN_FILENO, POLLIN, 0};
  return poll(&input, 1, Interval) > 0 ? Read() : Word::Nothing;
}
} // namespace

int main(int count, char** arguments)
{
  if (count != 2)
  {
    return 2;
  }
  Word word = Read();
  bool hasEnded = word == Word::End;
  const auto end = std::chrono::steady_clock::now() + Patience;
  while (word != Word::Quit && std::chrono::steady_clock::now() < end)
  {
    if (palpate::StopFalcon(arguments[1]).IsOk())
    {
      return 0;
    }
    word = Wait(hasEnded);
    hasEnded = hasEnded || word == Word::End;
  }
  return word == Word::Quit ? 0 : 1;
}
