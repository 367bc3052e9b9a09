#include "CohortAlignment.h"

#include "CohortNotes.h"
#include "CsvText.h"
#include "DecimalText.h"
#include "InputError.h"
#include "ModelFile.h"
#include "Progress.h"
#include "ShapeVector.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace palpate
{
namespace
{
constexpr double LargeTurn = 45.0; // degrees

// About the origin, where the cases are.
OrganModel CentredReference(const std::filesystem::path& file)
{
  const OrganModel model = ReadModel(file).Surface;
  OrganModel aligned = model;
  const Status status = AlignShape(model, AlignmentAxes::Patient, aligned);
  if (!status.IsOk())
  {
    throw InputError(file.string() + ": " + status.Message());
  }
  return aligned;
}

// Of the body: of radial models the parameters turn with it.
double TurnOf(const OrganModel& model, const SphereRotation& rotation)
{
  const bool isRadial = std::holds_alternative<RadialModel>(model);
  const Matrix3& turn = isRadial ? rotation.Parameters : rotation.Body;
  return 180.0 / M_PI * AngleOf(turn);
}

void NoteAlignment(CohortGroup& group, const CohortAlignment& alignment)
{
  std::vector<CohortNote> ambiguous;
  std::vector<CohortNote> mirrored;
  std::vector<CohortNote> turned;
  for (std::size_t i = 0; i < alignment.Cases.size(); ++i)
  {
    const ProcrustesCase& one = alignment.Cases[i];
    const std::string& name = group.Rows[i].Case;
    const std::string residual = FixedText(one.ShapeResidual, 2) + " mm from the mean, but ";
    const double turn = TurnOf(group.Models[i], one.Rotation);
    if (one.IsAmbiguous())
    {
      ambiguous.push_back({name, ": its orientation is ambiguous, " + residual +
                                     FixedText(one.FlippedResidual, 2) + " mm after half a turn"});
    }
    if (one.IsMirrored())
    {
      mirrored.push_back({name, ": it looks mirrored, " + residual +
                                    FixedText(one.MirroredResidual, 2) +
                                    " mm as its mirror image"});
    }
    if (turn > LargeTurn)
    {
      turned.push_back(
          {name, ": it is turned by " + FixedText(turn, 0) + " degrees from the patient's axes"});
    }
  }
  AddCohortNotes(
      ambiguous,
      "have an ambiguous orientation: half a turn would be nearly as close to the mean, or "
      "closer",
      "alignment.csv", group);
  AddCohortNotes(mirrored, "look mirrored: their mirror images are closer to the mean",
                 "alignment.csv", group);
  AddCohortNotes(turned, "are turned by more than 45 degrees from the patients' axes",
                 "alignment.csv", group);
}
} // namespace

CohortAlignment AlignCohortGroup(CohortGroup& group, bool isScaled,
                                 const std::filesystem::path& reference,
                                 const KernelProgress& progress)
{
  std::optional<OrganModel> target;
  if (!reference.empty())
  {
    target = CentredReference(reference);
    const int degree = std::max(DegreeOf(*target), DegreeOf(group.Models.front()));
    target = WithDegree(*target, degree);
    for (OrganModel& model : group.Models)
    {
      model = WithDegree(model, degree);
    }
  }
  ProcrustesSettings settings;
  settings.Scales = isScaled;
  ProcrustesResult result;
  bool isCancelled = false;
  const KernelProgress watched = [&](double done)
  {
    isCancelled = progress && !progress(done);
    return !isCancelled;
  };
  Status status =
      AlignByProcrustes(group.Models, target ? &*target : nullptr, settings, result, watched);
  if (isCancelled)
  {
    throw Cancelled();
  }
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
  std::string text = CsvLine({"case", "label", "turn_deg", "scale", "residual_mm", "shape_mm",
                              "flipped_mm", "flip_ratio", "mirrored_mm", "ambiguous", "mirrored"});
  for (std::size_t i = 0; i < alignment.Cases.size(); ++i)
  {
    const ProcrustesCase& one = alignment.Cases[i];
    text += CsvLine({group.Rows[i].Case, std::to_string(group.Rows[i].Result.Structure.Label),
                     ExactText(TurnOf(group.Models[i], one.Rotation)), ExactText(one.Scale),
                     ExactText(one.Residual), ExactText(one.ShapeResidual),
                     ExactText(one.FlippedResidual), ExactText(one.FlipRatio()),
                     ExactText(one.MirroredResidual), one.IsAmbiguous() ? "yes" : "no",
                     one.IsMirrored() ? "yes" : "no"});
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
