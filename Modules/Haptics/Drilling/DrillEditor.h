#pragma once

#include "CutTool.h"
#include "DrillLink.h"
#include "DrilledField.h"
#include "Status.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace palpate
{
/// The current fields of a drilled scene.
struct DrillReading
{
  std::uint64_t Number = 0;                               ///< all orders below it are executed
  std::vector<std::shared_ptr<const ScalarField>> Fields; ///< one for each site
  bool CanUndo = false;
  bool CanRedo = false;
  std::string Problem; ///< why material was not removed or updated; empty if none
};

/// Executes a servo's orders on the fields that it drills, and passes the new versions back.
/// Strokes of all fields are undone together. The client calls Take repeatedly; this class creates
/// no thread. All members are thread-safe; edits are serialised, and readers do not wait for them.
///
/// The resulting fields depend on the orders alone, not on how they are distributed over calls.
class DrillEditor
{
public:
  /// From initial fields: one for each site.
  static Status Make(std::vector<std::unique_ptr<DrilledField>> fields,
                     std::unique_ptr<DrillEditor>& editor);

  /// `number` identifies the tool in orders (TouchDrill::Tool). Fails for an invalid tool.
  Status AddTool(const CutTool& tool, int& number);
  /// For the scene.
  const std::shared_ptr<DrillLink>& Link() const noexcept { return this->Shared; }

  /// Executes the received orders below `until`, and publishes the resulting versions. Returns
  /// whether anything has changed since the last call.
  bool Take(std::uint64_t until = std::numeric_limits<std::uint64_t>::max());

  /// Prepares for a new servo, which numbers its orders from 0: all orders of the last one are
  /// done.
  void ForNextServo();

  DrillReading Newest() const;
  /// Removed volume of each site, mm^3.
  std::vector<double> RemovedVolumes();

  /// The removed region of each site, to be saved. Later cuts belong to a new stroke, so send
  /// DrillCommand::EndStroke first if the session is recorded.
  std::vector<std::shared_ptr<const RemovedDistances>> Removed();
  /// Replaces the removed regions by saved ones, before a servo has given any order. Fails for
  /// those of other volumes.
  Status Restore(const std::vector<std::shared_ptr<const RemovedDistances>>& removed);
  /// The same as the state that drilling begins with: neither this nor what was done before can be
  /// undone.
  Status BeginWith(const std::vector<std::shared_ptr<const RemovedDistances>>& removed);
  /// Whether the removed regions are these objects, as Removed returned them; null: nothing is
  /// removed. Ends no stroke.
  bool Holds(const std::vector<std::shared_ptr<const RemovedDistances>>& removed) const;

  /// DrilledField::WriteSamples of a site.
  void WriteSamples(int site, const FieldSamples& original, void* drilled) const;

  /// Constant properties of a site: its NodeCut, material and channel.
  const DrilledField& Site(int site) const { return *this->Fields[static_cast<std::size_t>(site)]; }
  /// The region removed at a site now, without ending a stroke: signed distances (mm, negative
  /// where removed) at nodes of a part of the grid that contains all of it, i fastest; empty if
  /// nothing is removed.
  struct RemovedPart
  {
    FieldGrid Grid;
    std::vector<float> Distances;
  };
  RemovedPart CopyRemoved(int site) const;
  /// Of all fields.
  std::size_t Bytes() const;

private:
  using State = std::shared_ptr<const RemovedDistances>;

  explicit DrillEditor(std::vector<std::unique_ptr<DrilledField>> fields);
  bool NextOrder(std::uint64_t until);
  void Do(const CutOrder& order);
  void Cut(const CutOrder& order);
  void EndStroke();
  void Undo();
  void Redo();
  void Reset();
  std::vector<std::size_t> ChangedSites();
  void Push(std::vector<std::size_t> sites);
  bool HasOpenStroke() const;
  Status PutBack(const std::vector<State>& removed);
  Status HandOver();

  std::shared_ptr<DrillLink> Shared = std::make_shared<DrillLink>();
  mutable std::mutex Editing; // guards everything up to the next mutex
  std::vector<std::unique_ptr<DrilledField>> Fields;
  std::vector<Eigen::AlignedBox3d> Bounds; // mm, of the undrilled fields
  std::vector<CutTool> Tools;
  std::vector<State> Before;                     // of each site, after the last stroke
  std::vector<std::vector<std::size_t>> Strokes; // sites that each stroke changed
  std::size_t Place = 0;                         // in Strokes
  std::optional<CutOrder> Order;                 // the next one
  std::uint64_t Done = 0;                        // orders
  std::uint64_t GrownAt = 0;
  bool IsHandedOver = false;
  std::string CutProblem;
  mutable std::mutex Reading; // guards what follows
  DrillReading Known;
};
} // namespace palpate
