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
/// The fields of a drilled scene as they are now.
struct DrillReading
{
  std::uint64_t Number = 0;                               ///< all orders below it are done
  std::vector<std::shared_ptr<const ScalarField>> Fields; ///< one for each site
  bool CanUndo = false;
  bool CanRedo = false;
  std::string Problem; ///< why not all is removed or shown; empty without
};

/// Does what a servo orders to the fields that it drills, and hands it the versions. Strokes of all
/// fields are undone together. Anybody who has time calls Take, again and again: it makes no
/// thread, and any thread may call what there is; those who edit wait for each other, who reads
/// does not wait for them.
///
/// What becomes of the fields follows from orders alone, in whatever portions they are taken.
class DrillEditor
{
public:
  /// Of fields as they were made: one for each site.
  static Status Make(std::vector<std::unique_ptr<DrilledField>> fields,
                     std::unique_ptr<DrillEditor>& editor);

  /// The number by which orders name it (TouchDrill::Tool). Refuses what is none.
  Status AddTool(const CutTool& tool, int& number);
  /// For the scene.
  const std::shared_ptr<DrillLink>& Link() const noexcept { return this->Shared; }

  /// Does the orders below `until` that have come, and hands over what became of the fields.
  /// Whether anything is different since the last call.
  bool Take(std::uint64_t until = std::numeric_limits<std::uint64_t>::max());

  /// Another servo begins, which numbers its orders from 0: those of the last one are done.
  void ForNextServo();

  DrillReading Newest() const;
  /// mm^3 that are gone, of each site.
  std::vector<double> RemovedVolumes();

  /// What is removed at each site, to be kept. What is cut afterwards is a stroke of its own, so
  /// who records sends DrillCommand::EndStroke before.
  std::vector<std::shared_ptr<const RemovedDistances>> Removed();
  /// Instead of what is there: what was kept earlier, before a servo has ordered anything. Refuses
  /// what is of other volumes.
  Status Restore(const std::vector<std::shared_ptr<const RemovedDistances>>& removed);

  /// DrilledField::WriteSamples of a site.
  void WriteSamples(int site, const FieldSamples& original, void* drilled) const;

  int SiteCount() const noexcept { return static_cast<int>(this->Fields.size()); }
  /// What does not change of a site: its law of cuts, its material, its channel.
  const DrilledField& Site(int site) const { return *this->Fields[static_cast<std::size_t>(site)]; }
  /// What is removed at a site now, without ending a stroke: signed distances (mm, negative where
  /// it is gone) at nodes of a part of the grid that holds all of it, i fastest; none where nothing
  /// is.
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
  Status HandOver();

  std::shared_ptr<DrillLink> Shared = std::make_shared<DrillLink>();
  mutable std::mutex Editing; // of all down to the next mutex
  std::vector<std::unique_ptr<DrilledField>> Fields;
  std::vector<Eigen::AlignedBox3d> Bounds; // mm, of the undrilled fields
  std::vector<CutTool> Tools;
  std::vector<State> Before;                     // of each site, after the last stroke
  std::vector<std::vector<std::size_t>> Strokes; // which sites each of them changed
  std::size_t Place = 0;                         // in it
  std::optional<CutOrder> Order;                 // the next
  std::uint64_t Done = 0;                        // orders
  std::uint64_t GrownAt = 0;
  bool IsHandedOver = false;
  std::string CutProblem;
  mutable std::mutex Reading; // of what follows
  DrillReading Known;
};
} // namespace palpate
