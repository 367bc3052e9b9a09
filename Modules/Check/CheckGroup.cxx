#include "CheckGroup.h"

#include "CheckRule.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace palpate
{
namespace
{
constexpr double TinyScore = 1e-300;
constexpr double LeastLogVolumeSpread = 0.01;
constexpr double LeastPlaceSpread = 0.5; // mm

// Mean and standard deviation of the values at these places, one left out.
struct Spread
{
  double Mean = 0.0;
  double Deviation = 0.0;

  Spread(const std::vector<double>& values, const std::vector<bool>& isTaken, std::size_t without)
  {
    double count = 0.0;
    double squares = 0.0;
    for (std::size_t n = 0; n < values.size(); ++n)
    {
      if (isTaken[n] && n != without)
      {
        count += 1.0;
        const double difference = values[n] - this->Mean;
        this->Mean += difference / count;
        squares += difference * (values[n] - this->Mean);
      }
    }
    this->Deviation = std::sqrt(squares / std::max(count - 1.0, 1.0));
  }
};

const CheckedOrgan* FindOrgan(const CheckedCase& patient, const std::string& name)
{
  const auto found = std::find_if(patient.Organs.begin(), patient.Organs.end(),
                                  [&](const CheckedOrgan& one) { return one.Name == name; });
  return found == patient.Organs.end() ? nullptr : &*found;
}

Vector3 MedianOf(const std::vector<Vector3>& points)
{
  Vector3 median;
  std::vector<double> values(points.size());
  for (Eigen::Index axis = 0; axis < 3; ++axis)
  {
    std::transform(points.begin(), points.end(), values.begin(),
                   [axis](const Vector3& point) { return point[axis]; });
    std::sort(values.begin(), values.end());
    median[axis] = 0.5 * (values[(values.size() - 1) / 2] + values[values.size() / 2]);
  }
  return median;
}

// How far an organ lies from its place in the layout, by the median of the others. False if the
// case has no other organ of the group.
bool OffsetInLayout(const CheckedCase& patient, const std::string& name,
                    const std::map<std::string, Vector3>& layout, Vector3& offset)
{
  std::vector<Vector3> others;
  for (const CheckedOrgan& organ : patient.Organs)
  {
    const auto place = layout.find(organ.Name);
    if (place == layout.end() || organ.IsWhole)
    {
      continue;
    }
    if (organ.Name == name)
    {
      offset = organ.Measured.Centroid - place->second;
    }
    else
    {
      others.push_back(organ.Measured.Centroid - place->second);
    }
  }
  if (others.empty() || layout.find(name) == layout.end())
  {
    return false;
  }
  offset -= MedianOf(others);
  return true;
}

// Mean places of the organs, from the mean place of all organs of a case.
std::map<std::string, Vector3> LayoutOf(const std::vector<CheckedCase>& cases,
                                        const std::vector<GroupOrgan>& organs)
{
  std::map<std::string, Vector3> layout;
  std::map<std::string, double> counts;
  for (const CheckedCase& patient : cases)
  {
    Vector3 middle = Vector3::Zero();
    std::vector<const CheckedOrgan*> present;
    for (const GroupOrgan& organ : organs)
    {
      const CheckedOrgan* const found = FindOrgan(patient, organ.Name);
      if (found != nullptr && !found->IsWhole)
      {
        present.push_back(found);
        middle += found->Measured.Centroid;
      }
    }
    for (const CheckedOrgan* organ : present)
    {
      const Vector3 place = organ->Measured.Centroid - middle / static_cast<double>(present.size());
      Vector3& mean = layout.try_emplace(organ->Name, Vector3::Zero()).first->second;
      mean += (place - mean) / ++counts[organ->Name];
    }
  }
  return layout;
}

MaskStatistic SizeStatistic(double logVolume, double mean, double deviation, const Vector3& place)
{
  return {"size", std::abs(logVolume - mean) / std::max(deviation, LeastLogVolumeSpread), place,
          std::exp(logVolume - mean)};
}

MaskStatistic PositionStatistic(const Vector3& offset, const Vector3& mean, const Vector3& spread,
                                const Vector3& place)
{
  const Vector3 difference = offset - mean;
  const Vector3 least = spread.cwiseMax(LeastPlaceSpread);
  return {"position", difference.cwiseQuotient(least).norm(), place, difference.norm()};
}

// The statistics of one organ's cases.
class OrganCases
{
public:
  OrganCases(const std::vector<CheckedCase>& cases, GroupOrgan& organ) : Organ(organ)
  {
    for (std::size_t n = 0; n < cases.size(); ++n)
    {
      if (const CheckedOrgan* const found = FindOrgan(cases[n], organ.Name))
      {
        this->Places.push_back(n);
        this->Measured.push_back(&found->Measured);
        this->Outlines.push_back(found->Measured.Outline);
        this->LogVolumes.push_back(std::log(found->Measured.Milliliters));
      }
    }
  }

  std::size_t Count() const { return this->Places.size(); }
  const std::vector<std::size_t>& InList() const { return this->Places; }
  const std::vector<bool>& Kept() const { return this->IsKept; }
  const MaskStatistics& StatisticsOf(std::size_t n) const { return this->All[n]; }

  void Describe(const std::vector<CheckedCase>& cases, const std::map<std::string, Vector3>& layout,
                const OutlineTemplates& templates, std::size_t atATime)
  {
    this->IsKept = TrimGroup(this->Outlines, templates, atATime, this->All);
    const Eigen::MatrixXd rows = OutlineRows(this->Outlines, this->IsKept, this->Count());
    this->Organ.Cases = static_cast<std::size_t>(rows.rows());
    this->Organ.Shape = ShapeGroup(rows, templates);
    const Spread volumes(this->LogVolumes, this->IsKept, this->Count());
    this->Organ.MeanLogVolume = volumes.Mean;
    this->Organ.LogVolumeSpread = volumes.Deviation;
    this->AddPositions(cases, layout);
    std::map<std::string, std::vector<double>> values;
    for (std::size_t n = 0; n < this->Count(); ++n)
    {
      const Spread others(this->LogVolumes, this->IsKept, n);
      this->All[n].push_back(SizeStatistic(this->LogVolumes[n], others.Mean, others.Deviation,
                                           this->Measured[n]->Centroid));
      const MaskStatistics& own = this->Measured[n]->Statistics;
      this->All[n].insert(this->All[n].end(), own.begin(), own.end());
      for (const MaskStatistic& one : this->All[n])
      {
        if (this->IsKept[n])
        {
          values[one.Key].push_back(one.Value);
        }
      }
    }
    for (auto& [key, list] : values)
    {
      if (const CheckRule* const rule = FindCheckRule(key))
      {
        this->Organ.Statistics[key] = TailProbability(std::move(list), *rule);
      }
    }
  }

private:
  void AddPositions(const std::vector<CheckedCase>& cases,
                    const std::map<std::string, Vector3>& layout)
  {
    std::vector<bool> isTaken(this->Count(), false);
    std::array<std::vector<double>, 3> offsets;
    for (std::size_t n = 0; n < this->Count(); ++n)
    {
      Vector3 offset = Vector3::Zero();
      const bool isPlaced =
          OffsetInLayout(cases[this->Places[n]], this->Organ.Name, layout, offset);
      isTaken[n] = isPlaced && this->IsKept[n];
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        offsets[axis].push_back(isPlaced ? offset[static_cast<Eigen::Index>(axis)]
                                         : std::numeric_limits<double>::quiet_NaN());
      }
    }
    const auto place = layout.find(this->Organ.Name);
    if (place == layout.end())
    {
      return;
    }
    for (std::size_t n = 0; n <= this->Count(); ++n) // the last one: of all
    {
      const Spread x(offsets[0], isTaken, n);
      const Spread y(offsets[1], isTaken, n);
      const Spread z(offsets[2], isTaken, n);
      const Vector3 mean(x.Mean, y.Mean, z.Mean);
      const Vector3 spread(x.Deviation, y.Deviation, z.Deviation);
      if (n == this->Count())
      {
        this->Organ.Place = place->second;
        this->Organ.PlaceOffset = mean;
        this->Organ.PlaceSpread = spread;
      }
      else if (std::isfinite(offsets[0][n]))
      {
        this->All[n].push_back(PositionStatistic({offsets[0][n], offsets[1][n], offsets[2][n]},
                                                 mean, spread, this->Measured[n]->Centroid));
      }
    }
  }

  GroupOrgan& Organ;
  std::vector<std::size_t> Places; // in the list of cases
  std::vector<const MeasuredMask*> Measured;
  std::vector<RadialOutline> Outlines;
  std::vector<double> LogVolumes;
  std::vector<bool> IsKept;
  std::vector<MaskStatistics> All;
};

// The least probability over its share; of a case of the group its own values do not count.
double ScoreOf(const GroupOrgan& organ, const MaskStatistics& statistics, bool isOfGroup,
               std::vector<std::pair<double, const MaskStatistic*>>& rated)
{
  for (const MaskStatistic& one : statistics)
  {
    const CheckRule* const rule = FindCheckRule(one.Key);
    const auto found = organ.Statistics.find(one.Key);
    if (rule != nullptr && rule->Budget > 0.0 && found != organ.Statistics.end())
    {
      const double probability =
          found->second.Of(one.Value, isOfGroup ? one.Value : TailProbability::Without);
      rated.emplace_back(probability / BudgetOf(*rule), &one);
    }
  }
  std::sort(rated.begin(), rated.end(),
            [](const auto& a, const auto& b) { return a.first < b.first; });
  return rated.empty() ? std::numeric_limits<double>::infinity() : rated.front().first;
}

// The first organ of a case of which a rule states a fact.
std::optional<CheckGroup::Odd> UnfitOrgan(const CheckedCase& patient, std::size_t place)
{
  for (const CheckedOrgan& organ : patient.Organs)
  {
    const OrganJudgement judged = JudgeByRules(organ, true);
    if (judged.Is != OrganJudgement::Verdict::Plausible)
    {
      return CheckGroup::Odd{place, organ.Name, judged.Reason};
    }
  }
  return std::nullopt;
}
} // namespace

CheckGroup CheckGroup::Of(const std::vector<CheckedCase>& given, std::size_t atATime)
{
  CheckGroup group;
  std::vector<CheckedCase> cases;
  std::vector<std::size_t> places;
  for (std::size_t n = 0; n < given.size(); ++n)
  {
    if (const std::optional<Odd> unfit = UnfitOrgan(given[n], n))
    {
      group.Dropped.push_back(*unfit);
    }
    else
    {
      cases.push_back(given[n]);
      places.push_back(n);
    }
  }
  std::map<std::string, std::size_t> counts;
  for (const CheckedCase& patient : cases)
  {
    for (const CheckedOrgan& organ : patient.Organs)
    {
      ++counts[organ.Name];
    }
  }
  for (const auto& [name, count] : counts)
  {
    if (count >= LeastCases)
    {
      group.Organs.emplace_back();
      group.Organs.back().Name = name;
    }
  }
  const std::size_t unfit = group.Dropped.size();
  group.Describe(cases, atATime);
  for (std::size_t n = unfit; n < group.Dropped.size(); ++n)
  {
    group.Dropped[n].Case = places[group.Dropped[n].Case];
  }
  return group;
}

void CheckGroup::Describe(const std::vector<CheckedCase>& cases, std::size_t atATime)
{
  const std::map<std::string, Vector3> layout = LayoutOf(cases, this->Organs);
  std::vector<double> scores(cases.size(), std::numeric_limits<double>::infinity());
  std::vector<double> counts(cases.size(), 0.0);
  for (GroupOrgan& organ : this->Organs)
  {
    OrganCases of(cases, organ);
    of.Describe(cases, layout, this->Templates, atATime);
    for (std::size_t n = 0; n < of.Count(); ++n)
    {
      std::vector<std::pair<double, const MaskStatistic*>> rated;
      const std::size_t place = of.InList()[n];
      scores[place] =
          std::min(scores[place], ScoreOf(organ, of.StatisticsOf(n), of.Kept()[n], rated));
      counts[place] += 1.0;
      if (!of.Kept()[n])
      {
        this->Dropped.push_back({place, organ.Name, of.StatisticsOf(n).front()});
      }
    }
  }
  for (std::size_t n = 0; n < cases.size(); ++n)
  {
    if (counts[n] > 0.0)
    {
      this->Scores.push_back(scores[n] * counts[n]);
    }
  }
  std::sort(this->Scores.begin(), this->Scores.end());
}

const GroupOrgan* CheckGroup::Find(const std::string& name) const
{
  const auto found = std::find_if(this->Organs.begin(), this->Organs.end(),
                                  [&](const GroupOrgan& one) { return one.Name == name; });
  return found == this->Organs.end() ? nullptr : &*found;
}

void CheckGroup::AddStatistics(const GroupOrgan& organ, const CheckedCase& patient,
                               CheckedOrgan& checked) const
{
  MeasuredMask& measured = checked.Measured;
  const MaskStatistics shape = organ.Shape.Judge(measured.Outline, this->Templates);
  measured.Statistics.insert(measured.Statistics.end(), shape.begin(), shape.end());
  measured.Statistics.push_back(SizeStatistic(std::log(measured.Milliliters), organ.MeanLogVolume,
                                              organ.LogVolumeSpread, measured.Centroid));
  std::map<std::string, Vector3> layout;
  for (const GroupOrgan& one : this->Organs)
  {
    if (one.Name != CheckedCase::WholeName)
    {
      layout[one.Name] = one.Place;
    }
  }
  Vector3 offset = Vector3::Zero();
  if (OffsetInLayout(patient, checked.Name, layout, offset))
  {
    measured.Statistics.push_back(
        PositionStatistic(offset, organ.PlaceOffset, organ.PlaceSpread, measured.Centroid));
  }
}

std::vector<OrganJudgement> CheckGroup::Judge(CheckedCase& patient, double rate) const
{
  std::vector<OrganJudgement> judged;
  double organs = 0.0;
  for (const CheckedOrgan& checked : patient.Organs)
  {
    organs += this->Find(checked.Name) != nullptr ? 1.0 : 0.0;
  }
  for (CheckedOrgan& checked : patient.Organs)
  {
    const GroupOrgan* const organ = this->Find(checked.Name);
    if (organ == nullptr)
    {
      judged.push_back(JudgeByRules(checked));
      continue;
    }
    this->AddStatistics(*organ, patient, checked);
    OrganJudgement judgement = this->JudgeOrgan(*organ, checked, organs, rate);
    const OrganJudgement facts = JudgeByRules(checked, true);
    if (facts.Is != OrganJudgement::Verdict::Plausible && facts.Is >= judgement.Is)
    {
      if (judgement.Is != OrganJudgement::Verdict::Plausible)
      {
        judgement.Others.push_back(judgement.Reason);
      }
      judgement.Is = facts.Is;
      judgement.Reason = facts.Reason;
    }
    judged.push_back(std::move(judgement));
  }
  return judged;
}

double CheckGroup::ProbabilityOf(double score) const
{
  const auto next = std::upper_bound(this->Scores.begin(), this->Scores.end(), score);
  const auto atMost = static_cast<double>(next - this->Scores.begin());
  const auto count = static_cast<double>(this->Scores.size());
  if (next == this->Scores.begin() || next == this->Scores.end())
  {
    return std::max(atMost, 1.0) / (count + 1.0);
  }
  const double least = std::log(std::max(*(next - 1), TinyScore));
  const double most = std::log(std::max(*next, TinyScore));
  const double part =
      most > least ? (std::log(std::max(score, TinyScore)) - least) / (most - least) : 0.0;
  return (atMost + part) / (count + 1.0);
}

double CheckGroup::ProbabilityOf(const std::string& organ, const MaskStatistic& one) const
{
  const GroupOrgan* const known = this->Find(organ);
  if (known == nullptr || known->Statistics.count(one.Key) == 0)
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  return known->Statistics.at(one.Key).Of(one.Value);
}

double CheckGroup::ScoreAt(double probability) const
{
  const double rank = probability * static_cast<double>(this->Scores.size() + 1);
  const auto below = static_cast<std::size_t>(rank);
  if (below == 0)
  {
    return 0.0;
  }
  if (below >= this->Scores.size())
  {
    return this->Scores.empty() ? 0.0 : this->Scores.back();
  }
  const double least = std::log(std::max(this->Scores[below - 1], TinyScore));
  const double most = std::log(std::max(this->Scores[below], TinyScore));
  return std::exp(least + (rank - static_cast<double>(below)) * (most - least));
}

OrganJudgement CheckGroup::JudgeOrgan(const GroupOrgan& organ, const CheckedOrgan& checked,
                                      double organs, double rate) const
{
  constexpr double MuchLess = 0.1; // of the limit of an alarm
  std::vector<std::pair<double, const MaskStatistic*>> rated;
  OrganJudgement judgement;
  judgement.IsByGroup = true;
  judgement.Score = organs * ScoreOf(organ, checked.Measured.Statistics, false, rated);
  judgement.Probability = this->ProbabilityOf(judgement.Score);
  judgement.Reason = rated.empty() ? MaskStatistic() : *rated.front().second;
  const double limit = this->ScoreAt(rate);
  if (judgement.Score < limit)
  {
    judgement.Is = judgement.Score < MuchLess * limit ? OrganJudgement::Verdict::Implausible
                                                      : OrganJudgement::Verdict::LookHere;
  }
  for (std::size_t n = 1; n < rated.size(); ++n)
  {
    if (organs * rated[n].first < limit)
    {
      judgement.Others.push_back(*rated[n].second);
    }
  }
  return judgement;
}

OrganJudgement JudgeByRules(const CheckedOrgan& organ, bool byFactsOnly)
{
  OrganJudgement judgement;
  judgement.Score = 1.0;
  const CheckRule* first = nullptr; // in the order of the sentences
  for (const MaskStatistic& one : organ.Measured.Statistics)
  {
    const CheckRule* const rule = FindCheckRule(one.Key);
    if (rule == nullptr || one.Value < rule->Look || (byFactsOnly && rule->Budget > 0.0))
    {
      continue;
    }
    const auto verdict = one.Value >= rule->Implausible ? OrganJudgement::Verdict::Implausible
                                                        : OrganJudgement::Verdict::LookHere;
    const bool isFirst = verdict > judgement.Is || (verdict == judgement.Is && rule < first);
    if (judgement.Is != OrganJudgement::Verdict::Plausible)
    {
      judgement.Others.push_back(isFirst ? judgement.Reason : one);
    }
    if (isFirst)
    {
      judgement.Is = verdict;
      judgement.Reason = one;
      first = rule;
    }
  }
  return judgement;
}
} // namespace palpate
