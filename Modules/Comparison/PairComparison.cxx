#include "PairComparison.h"

#include "CaseText.h"
#include "DecimalText.h"
#include "FitStructure.h"
#include "InputError.h"
#include "KernelWatch.h"
#include "StageClock.h"
#include "Units.h"

#include <cmath>

namespace palpate
{
namespace
{
constexpr double LargestIrregular = 0.005; // share of the inside, above that of tiny folds

ComparedSide SideOf(const ComparedFile& file, const Segment& structure)
{
  ComparedSide side;
  side.File = file.Path();
  side.Structure = structure;
  side.Kind = file.Kind();
  return side;
}

void Measure(const ComparedBody& body, ComparedSide& side)
{
  side.Milliliters = body.Volume() / CubicMillimetersPerMilliliter;
  side.Area = body.Area();
  side.Holes = body.HoleCount();
  side.Irregular = body.Irregular();
}

// Whether two files seem to have the same structure; different organs are apart.
bool AreOfOneName(const PairComparison& pair)
{
  const std::string& name = pair.One.Structure.Name;
  const bool isNamed = !name.empty() || !pair.Other.Structure.Name.empty();
  return pair.One.File != pair.Other.File &&
         (isNamed ? name == pair.Other.Structure.Name
                  : pair.One.File.filename() == pair.Other.File.filename());
}

using BodyPointer = std::shared_ptr<const ComparedBody>;

// A mask without its steps; a surface or a model is its own shape, as it was made.
BodyPointer ShapeOf(const ComparedFile& file, const Segment& structure, const BodyPointer& made)
{
  return file.Labels() == nullptr
             ? made
             : std::make_shared<const ComparedBody>(file.Body(structure, MaskBody::Shape));
}

BodyPointer OtherBodyOf(PairComparison& pair, const ComparedFile& one, const ComparedFile& other,
                        const PairSettings& settings, KernelWatch& watch)
{
  ComparedBody body = other.Body(pair.Other.Structure);
  if (settings.IsMirrored)
  {
    Measure(body, pair.Other);
    MirrorMatch match;
    if (other.Labels() != nullptr)
    {
      body = other.Body(pair.Other.Structure, MaskBody::Shape);
    }
    const Status status = MirrorOnto(*ShapeOf(one, pair.One.Structure, pair.OneBody),
                                     watch.Of(0.1, 0.2), body, match);
    watch.Require();
    if (!status.IsOk())
    {
      throw InputError("the mirror image " + status.Message());
    }
    pair.Mirror = match;
    pair.Notes.push_back("the reference is its mirror image at the sagittal plane, turned by " +
                         FixedText(match.Turn * DegreesPerRadian, 1) + " degrees and moved by " +
                         FixedText(match.Shift.norm(), 1) + " mm onto the first");
  }
  return std::make_shared<const ComparedBody>(std::move(body));
}

void TakeMotion(const ComparedFile& one, const ComparedFile& other, const PairSettings& settings,
                KernelWatch& watch, PairComparison& pair)
{
  BodyMotion motion;
  // The mirror image is not what moves.
  const BodyPointer from =
      pair.Mirror
          ? std::make_shared<const ComparedBody>(other.Body(pair.Other.Structure, MaskBody::Shape))
          : ShapeOf(other, pair.Other.Structure, pair.OtherBody);
  const Status status = FindBodyMotion(*from, *ShapeOf(one, pair.One.Structure, pair.OneBody),
                                       settings.Landmarks, watch.Of(0.9, 1.0), motion);
  watch.Require();
  if (status.IsOk())
  {
    pair.Motion = std::move(motion);
  }
  else
  {
    pair.Notes.push_back("its motion is not known: it " + status.Message());
  }
}

void RemarkOn(PairComparison& pair)
{
  for (const ComparedSide* side : {&pair.One, &pair.Other})
  {
    if (side->Holes > 0)
    {
      pair.Notes.push_back(side->File.filename().string() + " is open (" +
                           CountText(side->Holes, "hole", "holes") +
                           "): it has no volume and no overlap, and distances from it no sign; "
                           "palpate fit --repair closes it");
    }
    if (side->Irregular > LargestIrregular)
    {
      pair.Notes.push_back(side->File.filename().string() + " encloses " +
                           FixedText(100.0 * side->Irregular, 1) +
                           " % of its inside not just once (it crosses itself, or has bodies in "
                           "each other or inside out): its volume and the signs of distances are "
                           "doubtful; palpate fit --repair models all that it encloses");
    }
  }
  if (pair.Numbers.Overlap && pair.Numbers.Overlap->Both == 0)
  {
    pair.Notes.push_back("the two share no volume; the least distance between them is " +
                         FixedText(pair.Numbers.LeastDistance, 2) + " mm" +
                         (AreOfOneName(pair)
                              ? "; if they are one structure, check that their files have one frame"
                              : ""));
  }
}
} // namespace

double PairComparison::ShapeAsymmetryPercent() const
{
  const double volume = CubicMillimetersPerMilliliter * this->One.Milliliters;
  return 100.0 * this->Numbers.Both.Rms / std::cbrt(3.0 * volume / (4.0 * M_PI));
}

void PairComparison::Forget()
{
  this->OneBody = nullptr;
  this->OtherBody = nullptr;
  for (DistanceMap* map : {&this->Numbers.OneToOther, &this->Numbers.OtherToOne})
  {
    map->Values = {};
    map->Samples = {};
  }
}

std::pair<std::string, std::string> TitlesOf(const PairComparison& pair)
{
  const std::string one = pair.One.Structure.Name;
  const std::string other = pair.Other.Structure.Name;
  if (!pair.Mirror && !one.empty() && !other.empty() && one != other)
  {
    return {one, other};
  }
  if (pair.Mirror)
  {
    const std::string& mirrored = other.empty() ? pair.Other.File.filename().string() : other;
    return {one.empty() ? pair.One.File.filename().string() : one, "mirrored " + mirrored};
  }
  const std::string oneFile = pair.One.File.filename().string();
  const std::string otherFile = pair.Other.File.filename().string();
  return oneFile != otherFile ? std::pair(oneFile, otherFile) : std::pair(oneFile, "the reference");
}

PairComparison ComparePair(const ComparedFile& one, const Segment& oneStructure,
                           const ComparedFile& other, const Segment& otherStructure,
                           const PairSettings& settings, const ProgressFunction& progress)
{
  PairComparison pair;
  pair.One = SideOf(one, oneStructure);
  pair.Other = SideOf(other, otherStructure);
  std::vector<std::pair<std::string, double>> stages;
  StageClock clock(stages);
  KernelWatch watch(progress, "distances");
  try
  {
    pair.OneBody = std::make_shared<const ComparedBody>(one.Body(oneStructure));
    watch.Of(0.0, 1.0)(0.1);
    watch.Require();
    pair.OtherBody = OtherBodyOf(pair, one, other, settings, watch);
  }
  catch (const InputError& error)
  {
    pair.State = FitResult::Outcome::BadInput;
    pair.Message = error.what();
    pair.Forget();
    return pair;
  }
  const Status status = CompareBodies(*pair.OneBody, *pair.OtherBody, settings.Tolerances,
                                      watch.Of(0.2, 1.0), pair.Numbers);
  watch.Require();
  if (!status.IsOk())
  {
    pair.State = FitResult::Outcome::Failed;
    pair.Message = status.Message();
    pair.Forget();
    return pair;
  }
  Measure(*pair.OneBody, pair.One);
  if (!pair.Mirror)
  {
    Measure(*pair.OtherBody, pair.Other);
  }
  if (settings.FindsMotion)
  {
    TakeMotion(one, other, settings, watch, pair);
  }
  RemarkOn(pair);
  clock.EndStage("compare");
  pair.Seconds = stages.front().second;
  return pair;
}
} // namespace palpate
