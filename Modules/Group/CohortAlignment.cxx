#include "CohortAlignment.h"

#include "CsvText.h"
#include "DecimalText.h"
#include "InputError.h"
#include "ModelFile.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace palpate
{
namespace
{

SurfaceModel WithDegree(const SurfaceModel& model, int degree)
{
  return std::visit([degree](const auto& one) -> SurfaceModel { return one.WithDegree(degree); },
                    model);
}

// About the origin, where the cases are.
SurfaceModel CentredReference(const std::filesystem::path& file)
{
  const SurfaceModel model = ReadModel(file).Surface;
  SurfaceModel aligned = model;
  const Status status = std::visit(
      [&](const auto& one)
      {
        auto moved = one;
        Status result = AlignShape(one, AlignmentAxes::Patient, moved);
        aligned = std::move(moved);
        return result;
      },
      model);
  if (!status.IsOk())
  {
    throw InputError(file.string() + ": " + status.Message());
  }
  return aligned;
}

// Of the body: of radial models the parameters turn with it.
double TurnOf(const SurfaceModel& model, const SphereRotation& rotation)
{
  const bool isRadial = std::holds_alternative<SphericalHarmonicModel>(model);
  const Matrix3& turn = isRadial ? rotation.Parameters : rotation.Body;
  return 180.0 / M_PI * AngleOf(turn);
}

void NoteAlignment(CohortGroup& group, const CohortAlignment& alignment)
{
  for (std::size_t i = 0; i < alignment.Cases.size(); ++i)
  {
    const ProcrustesCase& one = alignment.Cases[i];
    const std::string residual = FixedText(one.Residual, 2) + " mm from the mean";
    if (one.IsAmbiguous())
    {
      group.Notes.push_back({group.Rows[i].Case, ": its orientation is ambiguous, " + residual +
                                                     ", but " + FixedText(one.FlippedResidual, 2) +
                                                     " mm after half a turn"});
    }
    if (one.IsMirrored())
    {
      group.Notes.push_back({group.Rows[i].Case, ": it looks mirrored, " + residual + ", but " +
                                                     FixedText(one.MirroredResidual, 2) +
                                                     " mm as its mirror image"});
    }
  }
}
} // namespace

CohortAlignment AlignCohortGroup(CohortGroup& group, bool isScaled,
                                 const std::filesystem::path& reference)
{
  std::optional<SurfaceModel> target;
  if (!reference.empty())
  {
    target = CentredReference(reference);
    const int degree = std::max(DegreeOf(*target), DegreeOf(group.Models.front()));
    target = WithDegree(*target, degree);
    for (SurfaceModel& model : group.Models)
    {
      model = WithDegree(model, degree);
    }
  }
  ProcrustesSettings settings;
  settings.Scales = isScaled;
  ProcrustesResult result;
  Status status = AlignByProcrustes(group.Models, target ? &*target : nullptr, settings, result);
  if (status.IsOk())
  {
    group.Models = std::move(result.Aligned);
    status = FindShapeModes(CoefficientsOf(group), group.Modes);
  }
  if (!status.IsOk())
  {
    throw InputError((reference.empty() ? std::string() : reference.string() + ": ") +
                     status.Message());
  }
  group.Axes = AlignmentAxes::Procrustes;
  CohortAlignment alignment{std::move(result.Cases), isScaled, reference.filename().string(),
                            result.Rounds};
  NoteAlignment(group, alignment);
  return alignment;
}

std::string AlignmentTable(const CohortGroup& group, const CohortAlignment& alignment)
{
  std::string text = CsvLine({"case", "label", "turn_deg", "scale", "residual_mm", "flipped_mm",
                              "flip_ratio", "mirrored_mm", "ambiguous", "mirrored"});
  for (std::size_t i = 0; i < alignment.Cases.size(); ++i)
  {
    const ProcrustesCase& one = alignment.Cases[i];
    text += CsvLine({group.Rows[i].Case, std::to_string(group.Rows[i].Result.Structure.Label),
                     ExactText(TurnOf(group.Models[i], one.Rotation)), ExactText(one.Scale),
                     ExactText(one.Residual), ExactText(one.FlippedResidual),
                     ExactText(one.FlipRatio()), ExactText(one.MirroredResidual),
                     one.IsAmbiguous() ? "yes" : "no", one.IsMirrored() ? "yes" : "no"});
  }
  return text;
}

std::string AlignmentText(const CohortAlignment& alignment)
{
  const std::string target = alignment.Reference.empty()
                                 ? std::string("their mean (generalised Procrustes analysis, ") +
                                       std::to_string(alignment.Rounds) + " rounds)"
                                 : std::string("a given shape");
  return "each body is turned to " + target +
         (alignment.IsScaled ? ", and all are scaled to one size" : "");
}
} // namespace palpate
