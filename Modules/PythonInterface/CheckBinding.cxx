#include "CheckBinding.h"

#include "Arrays.h"
#include "Call.h"
#include "GridArray.h"
#include "Results.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>
#include <string>
#include <utility>
#include <vector>

namespace py = pybind11;

namespace palpate
{
namespace
{
/// palpate.MaskCase and palpate.CheckGroup. Immutable, so that threads may share them.
struct BoundCase
{
  Owned<palpate_case> Handle;
};
struct BoundGroup
{
  Owned<palpate_check_group> Handle;
};

/// The axes for the C interface: null if nobody gave them.
const double* AxesOf(const GridPlace& grid, const GridArguments& place)
{
  return place.Direction.is_none() && place.Affine.is_none() ? nullptr : grid.Axes.data();
}

std::vector<const char*> TextsOf(const std::vector<std::string>& texts)
{
  std::vector<const char*> pointers(texts.size());
  std::transform(texts.begin(), texts.end(), pointers.begin(),
                 [](const std::string& text) { return text.c_str(); });
  return pointers;
}

std::vector<std::int32_t> LabelsIn(const py::array& array)
{
  const std::string kind(1, array.dtype().kind());
  if (kind == "f")
  {
    throw py::type_error("masks: labels are integers, not of dtype " +
                         std::string(py::str(array.dtype())));
  }
  std::vector<std::int32_t> labels;
  for (const py::handle one : py::module_::import("numpy").attr("unique")(array))
  {
    const auto label = py::int_(py::reinterpret_borrow<py::object>(one)).cast<std::int64_t>();
    if (std::abs(label) > std::numeric_limits<std::int32_t>::max())
    {
      throw py::value_error("masks: the label " + std::to_string(label) + " is too large");
    }
    if (label != 0)
    {
      labels.push_back(static_cast<std::int32_t>(label));
    }
  }
  return labels;
}

BoundCase CaseOfLabels(const py::array& array, const py::object& givenNames,
                       const GridArguments& place)
{
  const GridPlace grid = PlaceOfGrid(array, "masks", place);
  const std::vector<std::int32_t> labels = LabelsIn(array);
  if (!givenNames.is_none() && !py::hasattr(givenNames, "get"))
  {
    throw py::value_error("names: of an array of labels, a mapping from labels to names is needed");
  }
  std::vector<std::string> names;
  for (const std::int32_t label : labels)
  {
    names.push_back(givenNames.is_none()
                        ? std::string()
                        : py::str(givenNames.attr("get")(label, "")).cast<std::string>());
  }
  const py::array_t<std::int32_t, py::array::f_style | py::array::forcecast> voxels(array);
  const std::vector<const char*> texts = TextsOf(names);
  const std::int32_t* const data = voxels.data();
  const py::gil_scoped_release others;
  return {Owned<palpate_case>(Call(palpate_case_of_labels, data, grid.Size.data(),
                                   grid.Origin.data(), grid.Spacing.data(), AxesOf(grid, place),
                                   labels.size(), labels.data(), texts.data()))};
}

BoundCase CaseOfMasks(const py::list& given, const std::vector<std::string>& names,
                      const GridArguments& place)
{
  if (given.empty() || names.size() != given.size())
  {
    throw py::value_error("names: there are " + std::to_string(names.size()) + " for " +
                          std::to_string(given.size()) + " masks");
  }
  using Mask = py::array_t<bool, py::array::f_style | py::array::forcecast>;
  GridPlace grid;
  std::vector<Mask> masks;
  std::vector<const std::uint8_t*> voxels;
  for (const py::handle one : given)
  {
    const py::array array = RealArray(py::reinterpret_borrow<py::object>(one), "masks");
    const GridPlace own = PlaceOfGrid(array, "masks", place);
    if (!masks.empty() && own.Size != grid.Size)
    {
      throw py::value_error("masks: their shapes differ");
    }
    grid = own;
    masks.emplace_back(array);
    voxels.push_back(reinterpret_cast<const std::uint8_t*>(masks.back().data()));
  }
  const std::vector<const char*> texts = TextsOf(names);
  const py::gil_scoped_release others;
  return {Owned<palpate_case>(Call(palpate_case_of_masks, voxels.data(), grid.Size.data(),
                                   grid.Origin.data(), grid.Spacing.data(), AxesOf(grid, place),
                                   voxels.size(), texts.data()))};
}

// An array of labels, a mapping from names to masks, or several masks.
BoundCase CaseOf(const py::object& given, const py::object& names, const GridArguments& place)
{
  const bool isMapping = py::hasattr(given, "keys");
  if (isMapping && !names.is_none())
  {
    throw py::value_error("names: the masks have names already");
  }
  if (!isMapping && !py::isinstance<py::list>(given) && !py::isinstance<py::tuple>(given))
  {
    const py::array array = RealArray(given, "masks");
    if (array.ndim() != 4)
    {
      return CaseOfLabels(array, names, place);
    }
  }
  const py::list masks(isMapping ? given.attr("values")() : given);
  std::vector<std::string> texts(masks.size());
  if (isMapping || !names.is_none())
  {
    texts.clear();
    for (const py::handle name : py::list(isMapping ? given.attr("keys")() : names))
    {
      texts.push_back(py::str(name).cast<std::string>());
    }
  }
  return CaseOfMasks(masks, texts, place);
}

py::list RulesOf(const palpate_checked* checked, std::size_t structure)
{
  py::list rules;
  palpate_rule one{};
  for (std::size_t k = 0; palpate_checked_rule(checked, structure, k, &one) != 0; ++k)
  {
    rules.append(
        Result("CheckedRule", one.key, one.value, Numbers(3, one.place), one.p, one.is_alarm != 0));
  }
  return rules;
}

py::list Check(const BoundCase& measured, const BoundGroup* group, double falseAlarms)
{
  if (!(falseAlarms > 0.0 && falseAlarms < 1.0))
  {
    throw py::value_error("false_alarms: a rate between 0 and 1 is needed");
  }
  Owned<palpate_checked> checked;
  {
    const py::gil_scoped_release others;
    checked.reset(Call(palpate_case_check, measured.Handle.get(),
                       group != nullptr ? group->Handle.get() : nullptr, falseAlarms));
  }
  constexpr const char* Words[] = {"plausible", "look here", "implausible"};
  py::list verdicts;
  palpate_verdict one{};
  for (std::size_t n = 0; palpate_checked_verdict(checked.get(), n, &one) != 0; ++n)
  {
    verdicts.append(Result("Verdict", one.name, Words[one.verdict], one.sentence, one.rule,
                           Numbers(3, one.place), one.p, one.volume, RulesOf(checked.get(), n)));
  }
  return verdicts;
}

BoundGroup GroupOf(const std::vector<const BoundCase*>& cases)
{
  std::vector<const palpate_case*> handles;
  for (const BoundCase* const one : cases)
  {
    handles.push_back(one != nullptr ? one->Handle.get() : nullptr);
  }
  const py::gil_scoped_release others;
  return {
      Owned<palpate_check_group>(Call(palpate_check_group_create, handles.data(), handles.size()))};
}

std::vector<std::pair<std::size_t, std::string>> DroppedOf(const BoundGroup& group)
{
  std::vector<std::pair<std::size_t, std::string>> dropped;
  std::size_t place = 0;
  for (std::size_t k = 0;; ++k)
  {
    const char* const why = palpate_check_group_dropped(group.Handle.get(), k, &place);
    if (why == nullptr)
    {
      return dropped;
    }
    dropped.emplace_back(place, why);
  }
}

constexpr const char* CaseHelp =
    "masks: an array of labels (i, j, k), integers of which 0 is outside; a mapping from names to "
    "masks; or several masks, which may overlap.\n"
    "names: of labels, a mapping from labels to names; of several masks, one for each.\n"
    "spacing, origin, direction, affine: the grid, as for fit_mask. Without direction and affine "
    "the patient's left and right are judged by pairs of names alone.\n";
} // namespace

void BindChecks(py::module_& module)
{
  // Both before their functions, whose signatures name them.
  py::class_<BoundCase> ofCase(module, "MaskCase",
                               "The masks of one patient, measured for checks.");
  py::class_<BoundGroup> ofGroup(module, "CheckGroup",
                                 "What clean cases look like, twenty of a structure at least.");
  ofGroup.def(py::init(&GroupOf), py::arg("cases"), "cases: MaskCases.")
      .def_property_readonly(
          "least_false_alarms",
          [](const BoundGroup& group)
          { return palpate_check_group_least_rate(group.Handle.get()); },
          "The least rate of false alarms that it can hold, 0 to 1.")
      .def_property_readonly("dropped", &DroppedOf,
                             "Odd cases that do not count: the place in the list, and why. Files "
                             "do not have them.")
      .def(
          "write",
          [](const BoundGroup& group, const std::filesystem::path& path)
          {
            const std::string name = path.string();
            const py::gil_scoped_release others;
            Call(palpate_check_group_write, group.Handle.get(), name.c_str());
          },
          py::arg("path"), "The file of palpate check --group.");
  module.def(
      "read_check_group",
      [](const std::filesystem::path& path)
      {
        const std::string name = path.string();
        const py::gil_scoped_release others;
        return BoundGroup{Owned<palpate_check_group>(Call(palpate_check_group_read, name.c_str()))};
      },
      py::arg("path"), "Reads what CheckGroup.write or palpate check --make-group has written.");
  ofCase
      .def(py::init(
               [](const py::object& masks, const py::object& names, const py::object& spacing,
                  const py::object& origin, const py::object& direction, const py::object& affine) {
                 return CaseOf(masks, names, {spacing, origin, direction, affine});
               }),
           py::arg("masks"), py::kw_only(), py::arg("names") = py::none(),
           py::arg("spacing") = py::none(), py::arg("origin") = py::none(),
           py::arg("direction") = py::none(), py::arg("affine") = py::none(), CaseHelp)
      .def("check", &Check, py::kw_only(), py::arg("group") = py::none(),
           py::arg("false_alarms") = 0.05, "As palpate.check.");
  module.def(
      "check",
      [](const py::object& masks, const py::object& names, const BoundGroup* group,
         double falseAlarms, const py::object& spacing, const py::object& origin,
         const py::object& direction, const py::object& affine) {
        return Check(CaseOf(masks, names, {spacing, origin, direction, affine}), group,
                     falseAlarms);
      },
      py::arg("masks"), py::kw_only(), py::arg("names") = py::none(), py::arg("group") = py::none(),
      py::arg("false_alarms") = 0.05, py::arg("spacing") = py::none(),
      py::arg("origin") = py::none(), py::arg("direction") = py::none(),
      py::arg("affine") = py::none(),
      (std::string("Whether masks can be believed: a Verdict for each structure, and for up to "
                   "eight together.\n\n") +
       CaseHelp +
       "group: a CheckGroup of clean cases; by fixed limits unless given.\n"
       "false_alarms: with a group, the rate of clean cases that may get another verdict than "
       "plausible.")
          .c_str());
}
} // namespace palpate
