#include "Segmentation.h"

#include "Refusal.h"

namespace palpate
{
const Segment& Segmentation::Find(const std::string& labelOrName) const
{
  // A label takes precedence over a name that is a number.
  for (const Segment& segment : this->Segments)
  {
    if (labelOrName == std::to_string(segment.Label))
    {
      return segment;
    }
  }
  const Segment* found = nullptr;
  std::string list;
  std::string same;
  for (const Segment& segment : this->Segments)
  {
    if (!segment.Name.empty() && labelOrName == segment.Name)
    {
      found = &segment;
      same += (same.empty() ? "" : ", ") + std::to_string(segment.Label);
    }
    list += (list.empty() ? "" : ", ") + std::to_string(segment.Label) +
            (segment.Name.empty() ? "" : " " + segment.Name);
  }
  if (found != nullptr && same == std::to_string(found->Label))
  {
    return *found;
  }
  if (found != nullptr)
  {
    Refuse(this->Source, "has several labels named " + labelOrName,
           "choose one of them by its number: " + same);
  }
  Refuse(this->Source, "has no label " + (labelOrName.empty() ? "''" : labelOrName),
         "choose one of those it has: " + list);
}

std::vector<std::string> Segmentation::Remarks() const
{
  std::vector<std::string> remarks = this->Notes;
  for (const RefusedMask& mask : this->Refused)
  {
    remarks.push_back(mask.Message);
  }
  return remarks;
}
} // namespace palpate
