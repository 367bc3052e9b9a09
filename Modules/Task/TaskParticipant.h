#pragma once

#include <cstdint>
#include <map>
#include <string>

namespace palpate
{
/// Who does a task: a number, and answers to the task's questions. Nothing else is known of people.
struct TaskParticipant
{
  int Number = 1;                             ///< from 1
  std::map<std::string, std::string> Answers; ///< by the questions' keys; those left out are empty
  std::string SimulatedLevel;                 ///< of a simulated hand; empty: a person
  std::uint64_t SimulationSeed = 0;
};
} // namespace palpate
