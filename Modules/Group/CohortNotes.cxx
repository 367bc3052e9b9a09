#include "CohortNotes.h"

namespace palpate
{
namespace
{
constexpr std::size_t MostNotes = 5;
} // namespace

void AddCohortNotes(const std::vector<CohortNote>& notes, const std::string& ofMany,
                    const std::string& table, CohortGroup& group)
{
  if (notes.size() <= MostNotes)
  {
    group.Notes.insert(group.Notes.end(), notes.begin(), notes.end());
    return;
  }
  group.Notes.push_back({notes.front().Case, " and " + std::to_string(notes.size() - 1) +
                                                 " other cases " + ofMany + " (" + table + ")"});
}
} // namespace palpate
