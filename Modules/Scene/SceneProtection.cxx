#include "SceneProtection.h"

#include "CaseText.h"
#include "DrilledField.h"
#include "InputError.h"
#include "Progress.h"

#include <algorithm>

namespace palpate
{
std::shared_ptr<const RemovedDistances> SceneProtection::On(const RemovedDistances& like) const
{
  const auto found = std::find_if(this->Kept.begin(), this->Kept.end(),
                                  [&like](const auto& kept) { return kept->IsLike(like); });
  return found != this->Kept.end() ? *found : nullptr;
}

std::size_t SceneProtection::Bytes() const
{
  constexpr std::size_t Kibibyte = 1024;
  // The cell tree of the triangles takes about as much memory as they do.
  std::size_t bytes = 2 * Kibibyte * this->Structure->Surface()->GetActualMemorySize();
  for (const auto& kept : this->Kept)
  {
    bytes += kept->BytesNotIn(nullptr);
  }
  return bytes;
}

SceneProtection MakeSceneProtection(vtkPolyData* surface,
                                    const std::vector<std::shared_ptr<const ScalarField>>& fields,
                                    const ProgressFunction& progress)
{
  SceneProtection made;
  made.Structure = std::make_shared<const ForbiddenStructure>(surface);
  const double part = 1.0 / static_cast<double>(std::max<std::size_t>(fields.size(), 1));
  for (const auto& field : fields)
  {
    const double done = part * static_cast<double>(made.Kept.size());
    const auto like = RemovedDistances::None(field->Grid(), DrilledField::BandOf(field->Grid()));
    made.Kept.push_back(ProtectionOf(*made.Structure, *like,
                                     [&](double fraction, const std::string& stage)
                                     { return progress(done + part * fraction, stage); }));
  }
  return made;
}
} // namespace palpate
