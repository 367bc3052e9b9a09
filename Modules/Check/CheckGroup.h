#pragma once

#include "CheckedCase.h"
#include "ShapeGroup.h"
#include "TailProbability.h"

#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace palpate
{
/// One organ over the clean cases of a group.
struct GroupOrgan
{
  std::string Name;
  std::size_t Cases = 0; ///< that stayed
  ShapeGroup Shape;
  double MeanLogVolume = 0.0; ///< ln of millilitres
  double LogVolumeSpread = 1.0;
  ///@{ Of the centroid in a layout of all organs, mm: its place, and mean and standard deviation
  /// of the cases' offsets from it along the patient's axes after a shift of the whole.
  Vector3 Place = Vector3::Zero();
  Vector3 PlaceOffset = Vector3::Zero();
  Vector3 PlaceSpread = Vector3::Ones();
  ///@}
  std::map<std::string, TailProbability> Statistics; ///< of the clean cases, each left out
};

/// How believable an organ is.
struct OrganJudgement
{
  enum class Verdict
  {
    Plausible,
    LookHere,
    Implausible
  };

  Verdict Is = Verdict::Plausible;
  bool IsByGroup = false;
  double Probability = 1.0;          ///< of a clean case with a score as small; without a group 1
  double Score = 1.0;                ///< least probability over its share of the false alarms
  MaskStatistic Reason;              ///< that gave the score, or the worst one
  std::vector<MaskStatistic> Others; ///< further statistics that alone would give a verdict
};

/// What clean cases look like, and how rarely they look worse.
///
/// Each statistic has a probability among the group's (TailProbability) and a share of the false
/// alarms (CheckRule::Budget). An organ's score is the least probability over the share, a case's
/// the least of its organs times their number. Scores of the group's own cases, each left out, and
/// of those whose shape is odd, which describe nothing else, calibrate the case's false alarms: an
/// alarm at the rate a is a score below the k-th smallest of n cases, k = floor(a (n + 1)), so that
/// one of 1/a new clean cases of the same kind has one (Vovk, Gammerman and Shafer, Algorithmic
/// Learning in a Random World, 2005).
class CheckGroup
{
public:
  /// An organ is described from as many cases on.
  static constexpr std::size_t LeastCases = 20;

  /// Of clean cases; those are left out of which rules state facts, such as a cut by the border of
  /// the image. Organs in fewer than LeastCases are left out; without any, there is no group.
  /// `atATime` threads.
  static CheckGroup Of(const std::vector<CheckedCase>& cases, std::size_t atATime);

  const GroupOrgan* Find(const std::string& name) const;
  /// The least rate of false alarms, 0..1, that the group can hold.
  double LeastRate() const { return 1.0 / static_cast<double>(this->Scores.size() + 1); }
  /// Of a clean case to have a score as small, at least LeastRate.
  double ProbabilityOf(double score) const;
  /// Of a clean case's organ of this name to have a statistic as large; NaN where none is known.
  double ProbabilityOf(const std::string& organ, const MaskStatistic& one) const;
  /// The score with that probability.
  double ScoreAt(double probability) const;
  /// For each organ of a case, at a rate of false alarms (0..1) of the whole case.
  std::vector<OrganJudgement> Judge(CheckedCase& patient, double rate) const;

  std::vector<GroupOrgan> Organs;
  std::vector<double> Scores; ///< of cases, sorted
  struct Odd
  {
    std::size_t Case; ///< place in the list, from 0
    std::string Organ;
    MaskStatistic Why; ///< "shape", or that of a rule that states a fact
  };
  std::vector<Odd> Dropped;

  OutlineTemplates Templates;

private:
  void Describe(const std::vector<CheckedCase>& cases, std::size_t atATime);
  void AddStatistics(const GroupOrgan& organ, const CheckedCase& patient,
                     CheckedOrgan& checked) const;
  OrganJudgement JudgeOrgan(const GroupOrgan& organ, const CheckedOrgan& checked, double organs,
                            double rate) const;
};

/// By the fixed limits of the rules alone, or of those that state facts (CheckRule::Budget 0).
OrganJudgement JudgeByRules(const CheckedOrgan& organ, bool byFactsOnly = false);
} // namespace palpate
