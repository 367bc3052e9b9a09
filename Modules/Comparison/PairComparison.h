#pragma once

#include "BodyComparison.h"
#include "BodyMotion.h"
#include "ComparedFile.h"
#include "FitResult.h"
#include "MirroredBody.h"
#include "PalpateComparisonModule.h"
#include "Progress.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace palpate
{
/// One of two compared structures, without its surface.
struct ComparedSide
{
  std::filesystem::path File;
  Segment Structure;        ///< label 0 of a surface or a model
  std::string Kind;         ///< of the file: "segmentation", "surface" or "model"
  double Milliliters = 0.0; ///< NaN of an open surface
  double Area = 0.0;        ///< mm^2
  int Holes = 0;            ///< of the surface
  double Irregular = 0.0;   ///< share of a surface's inside that it does not enclose just once
};

/// Result of one pair; the second is the reference.
struct PairComparison
{
  std::string Case; ///< of a folder or list; empty of a single pair
  ComparedSide One;
  ComparedSide Other;
  FitResult::Outcome State = FitResult::Outcome::Fitted; ///< or BadInput, Failed
  std::string Message;                                   ///< why it is not compared
  std::vector<std::string> Notes;
  std::optional<MirrorMatch> Mirror; ///< if the second is its mirror image
  std::optional<BodyMotion> Motion;  ///< from the second to the first, if that was asked for
  std::optional<double> Time;        ///< of the first, of images over time
  BodyComparison Numbers;
  ///@{ The surfaces; null if the pair was not compared, or once Forget was called.
  std::shared_ptr<const ComparedBody> OneBody;
  std::shared_ptr<const ComparedBody> OtherBody;
  ///@}
  double Seconds = 0.0; ///< to compare, without reading and writing
  ///@{ Of several pairs: sentences on structures of a case's files without a partner, in its first
  /// pair, and what the result depends on (KeyOfInputs).
  std::vector<std::string> Unpaired;
  std::string Key;
  ///@}

  bool IsCompared() const { return this->State == FitResult::Outcome::Fitted; }
  /// ml, and % of the reference.
  double VolumeDifference() const { return this->One.Milliliters - this->Other.Milliliters; }
  double VolumeDifferencePercent() const
  {
    return 100.0 * this->VolumeDifference() / this->Other.Milliliters;
  }
  ///@{ Of a mirror image: first minus second over their mean, %; RMS distance over the radius of a
  /// ball with the first's volume, %.
  double VolumeAsymmetryPercent() const
  {
    return 200.0 * this->VolumeDifference() / (this->One.Milliliters + this->Other.Milliliters);
  }
  PALPATECOMPARISON_EXPORT double ShapeAsymmetryPercent() const;
  ///@}
  /// Frees what a table does not need.
  PALPATECOMPARISON_EXPORT void Forget();
};

/// Names of a pair's two sides for people: their structures' names, or the files' if these are
/// equal or missing.
PALPATECOMPARISON_EXPORT std::pair<std::string, std::string> TitlesOf(const PairComparison& pair);

/// What else ComparePair is asked for.
struct PairSettings
{
  std::vector<double> Tolerances{1.0, 2.0, 3.0}; ///< mm, ascending
  bool IsMirrored = false;                       ///< the second is replaced as by MirrorOnto
  bool FindsMotion = false;
  std::vector<Vector3> Landmarks; ///< on the second, mm: they move with it
};

/// Compares two structures; problems of them are in State and Message. Throws Cancelled.
PALPATECOMPARISON_EXPORT PairComparison ComparePair(
    const ComparedFile& one, const Segment& oneStructure, const ComparedFile& other,
    const Segment& otherStructure, const PairSettings& settings, const ProgressFunction& progress);
} // namespace palpate
