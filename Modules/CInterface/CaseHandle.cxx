#include "CaseHandle.h"

#include "CaseMasks.h"
#include "CheckGroupFile.h"
#include "ErrorText.h"
#include "GridArgument.h"
#include "InputError.h"
#include "JudgementText.h"
#include "ProcessorCount.h"
#include "Units.h"

#include <algorithm>
#include <functional>
#include <limits>

namespace palpate
{
namespace
{
constexpr double NotKnown = std::numeric_limits<double>::quiet_NaN();

// A grid, as the interface has it; its axes may be missing.
struct CaseGrid
{
  const int* Size;
  const double* Origin;
  const double* Spacing;
  const double* Axes;
};

// Throws what the caller's guard tells.
IndexToWorld PlaceOf(const CaseGrid& grid)
{
  constexpr double Plain[9] = {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0};
  IndexToWorld toWorld;
  const Status status = PlaceGrid(grid.Size, grid.Origin, grid.Spacing,
                                  grid.Axes != nullptr ? grid.Axes : Plain, toWorld);
  if (!status.IsOk())
  {
    throw InputError(status.Message());
  }
  CheckVoxels(grid.Size);
  return toWorld;
}

// `crop` gives the voxels of a structure. Throws what the caller's guard tells.
palpate_case* MeasuredCase(const CaseGrid& grid, std::vector<CaseMasks::Structure> structures,
                           const std::function<VoxelMask(std::size_t)>& crop)
{
  if (structures.empty())
  {
    throw InputError("a case has one structure at least");
  }
  CaseMasks masks;
  masks.Structures = std::move(structures);
  masks.LayerCount = static_cast<std::size_t>(masks.Structures.back().Layer) + 1;
  masks.IsOriented = grid.Axes != nullptr;
  const IndexToWorld toWorld = PlaceOf(grid);
  masks.MaskOf = [&](std::size_t n)
  {
    CheckedMask mask{crop(n), toWorld, {grid.Size[0], grid.Size[1], grid.Size[2]}};
    if (mask.Voxels.Inside.empty())
    {
      const CaseMasks::Structure& one = masks.Structures[n];
      throw InputError("the structure " +
                       (one.Name.empty() ? "label " + std::to_string(one.Label) : one.Name) +
                       " has no voxels");
    }
    return mask;
  };
  static const RadialProbe probe; // never changes, and takes as long to make as a mask to measure
  return new palpate_case{MeasureCase(masks, probe, ProcessorCount())};
}

// Throws if a text is missing, which the caller's guard tells.
std::string NameAt(const char* const* names, std::size_t n)
{
  if (names[n] == nullptr)
  {
    throw InputError("a text of 'names' is NULL");
  }
  return names[n];
}

bool IsAlarm(const OrganJudgement& judgement, const MaskStatistic& one)
{
  const auto is = [&](const MaskStatistic& other) { return other.Key == one.Key; };
  return judgement.Is != OrganJudgement::Verdict::Plausible &&
         (is(judgement.Reason) ||
          std::any_of(judgement.Others.begin(), judgement.Others.end(), is));
}

void AddTexts(const CheckGroup* group, palpate_checked& checked)
{
  for (std::size_t n = 0; n < checked.Judgements.size(); ++n)
  {
    const CheckedOrgan& organ = checked.Patient.Organs[n];
    checked.Sentences.push_back(JudgementSentence(checked.Judgements[n]));
    checked.Probabilities.emplace_back();
    for (const MaskStatistic& one : organ.Measured.Statistics)
    {
      checked.Probabilities.back().push_back(
          group != nullptr ? group->ProbabilityOf(organ.Name, one) : NotKnown);
    }
  }
}
} // namespace
} // namespace palpate

using namespace palpate;

palpate_case* palpate_case_of_labels(const int32_t* labels, const int size[3],
                                     const double origin[3], const double spacing[3],
                                     const double axes[9], size_t structure_count,
                                     const int32_t* values, const char* const* names,
                                     palpate_error* error)
{
  return Guarded(error,
                 {{labels, "labels"},
                  {size, "size"},
                  {origin, "origin"},
                  {spacing, "spacing"},
                  {values, "values", structure_count},
                  {names, "names", structure_count}},
                 [&]
                 {
                   std::vector<CaseMasks::Structure> structures;
                   for (std::size_t n = 0; n < structure_count; ++n)
                   {
                     structures.push_back({NameAt(names, n), values[n], 0});
                   }
                   return MeasuredCase({size, origin, spacing, axes}, std::move(structures),
                                       [&](std::size_t n)
                                       { return CroppedLabel(labels, size, spacing, values[n]); });
                 });
}

palpate_case* palpate_case_of_masks(const uint8_t* const* masks, const int size[3],
                                    const double origin[3], const double spacing[3],
                                    const double axes[9], size_t structure_count,
                                    const char* const* names, palpate_error* error)
{
  return Guarded(error,
                 {{masks, "masks", structure_count},
                  {size, "size"},
                  {origin, "origin"},
                  {spacing, "spacing"},
                  {names, "names", structure_count}},
                 [&]
                 {
                   std::vector<CaseMasks::Structure> structures;
                   for (std::size_t n = 0; n < structure_count; ++n)
                   {
                     if (masks[n] == nullptr)
                     {
                       throw InputError("a mask of 'masks' is NULL");
                     }
                     const int number = static_cast<int>(n);
                     structures.push_back({NameAt(names, n), number + 1, number});
                   }
                   return MeasuredCase({size, origin, spacing, axes}, std::move(structures),
                                       [&](std::size_t n)
                                       { return CroppedMask(masks[n], size, spacing); });
                 });
}

void palpate_case_free(palpate_case* one)
{
  delete one;
}

palpate_check_group* palpate_check_group_create(const palpate_case* const* cases, size_t case_count,
                                                palpate_error* error)
{
  return Guarded(error, {{cases, "cases", case_count}},
                 [&]() -> palpate_check_group*
                 {
                   std::vector<CheckedCase> patients;
                   for (std::size_t n = 0; n < case_count; ++n)
                   {
                     if (cases[n] == nullptr)
                     {
                       SetError(error, "a case of 'cases' is NULL");
                       return nullptr;
                     }
                     patients.push_back(cases[n]->Patient);
                   }
                   palpate_check_group made{CheckGroup::Of(patients, ProcessorCount()), {}};
                   if (made.Group.Organs.empty())
                   {
                     SetError(error, FewCasesText(case_count));
                     return nullptr;
                   }
                   for (const CheckGroup::Odd& odd : made.Group.Dropped)
                   {
                     made.Dropped.push_back(OddCaseText(odd));
                   }
                   return new palpate_check_group(std::move(made));
                 });
}

palpate_check_group* palpate_check_group_read(const char* path, palpate_error* error)
{
  return Guarded(error, {{path, "path"}},
                 [&] {
                   return new palpate_check_group{ReadCheckGroup(path), {}};
                 });
}

int palpate_check_group_write(const palpate_check_group* group, const char* path,
                              palpate_error* error)
{
  return Guarded(error, {{group, "group"}, {path, "path"}},
                 [&]
                 {
                   WriteCheckGroup(group->Group, path);
                   return 1;
                 });
}

void palpate_check_group_free(palpate_check_group* group)
{
  delete group;
}

double palpate_check_group_least_rate(const palpate_check_group* group)
{
  return group != nullptr ? group->Group.LeastRate() : 0.0;
}

const char* palpate_check_group_dropped(const palpate_check_group* group, size_t k, size_t* place)
{
  if (group == nullptr || place == nullptr || k >= group->Dropped.size())
  {
    return nullptr;
  }
  *place = group->Group.Dropped[k].Case;
  return group->Dropped[k].c_str();
}

palpate_checked* palpate_case_check(const palpate_case* one, const palpate_check_group* group,
                                    double false_alarms, palpate_error* error)
{
  return Guarded(error, {{one, "one"}},
                 [&]() -> palpate_checked*
                 {
                   const CheckGroup* const clean = group != nullptr ? &group->Group : nullptr;
                   if (!(false_alarms > 0.0 && false_alarms < 1.0))
                   {
                     SetError(error, "the rate of false alarms is not between 0 and 1");
                     return nullptr;
                   }
                   if (clean != nullptr && false_alarms < clean->LeastRate())
                   {
                     SetError(error, "the group has too few cases for so few false alarms; ask "
                                     "for its least rate or more, or check without it");
                     return nullptr;
                   }
                   palpate_checked checked{one->Patient, {}, {}, {}};
                   checked.Judgements = JudgeCase(checked.Patient, clean, false_alarms);
                   AddTexts(clean, checked);
                   return new palpate_checked(std::move(checked));
                 });
}

void palpate_checked_free(palpate_checked* checked)
{
  delete checked;
}

int palpate_checked_verdict(const palpate_checked* checked, size_t structure,
                            palpate_verdict* found)
{
  if (checked == nullptr || found == nullptr || structure >= checked->Judgements.size())
  {
    return 0;
  }
  const OrganJudgement& judgement = checked->Judgements[structure];
  const CheckedOrgan& organ = checked->Patient.Organs[structure];
  const bool isPlausible = judgement.Is == OrganJudgement::Verdict::Plausible;
  *found = {organ.Name.c_str(),
            checked->Sentences[structure].c_str(),
            isPlausible ? "" : judgement.Reason.Key.c_str(),
            static_cast<int>(judgement.Is),
            {},
            judgement.IsByGroup ? judgement.Probability : NotKnown,
            CubicMillimetersPerMilliliter * organ.Measured.Milliliters};
  Copy(isPlausible ? Vector3(Vector3::Constant(NotKnown)) : judgement.Reason.Place, found->place);
  return 1;
}

int palpate_checked_rule(const palpate_checked* checked, size_t structure, size_t rule,
                         palpate_rule* found)
{
  if (checked == nullptr || found == nullptr || structure >= checked->Judgements.size() ||
      rule >= checked->Probabilities[structure].size())
  {
    return 0;
  }
  const MaskStatistic& one = checked->Patient.Organs[structure].Measured.Statistics[rule];
  *found = {one.Key.c_str(),
            one.Value,
            {},
            checked->Probabilities[structure][rule],
            IsAlarm(checked->Judgements[structure], one) ? 1 : 0};
  Copy(one.Place, found->place);
  return 1;
}
