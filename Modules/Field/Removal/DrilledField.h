#pragma once

#include "CutSweep.h"
#include "DistanceBox.h"
#include "DrilledBrick.h"
#include "DrilledVolume.h"
#include "EditedField.h"
#include "FieldSamples.h"
#include "RemovalStroke.h"
#include "Status.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace palpate
{
/// A field of which tools remove one material: cuts gather in strokes, which can be undone;
/// versions are immutable and may be used by any thread for as long as it likes, while the next
/// cuts are made. A version is the field that FieldBuilder would make of the samples as they are
/// now: its hits and what is inside have the same bits.
///
/// What cuts change is one channel, which no other material may be made of. So a structure that
/// must not be removed is a material of a channel of its own, or a label that limits this one.
///
/// One thread owns this. It allocates: not for a servo's tick.
class DrilledField
{
public:
  /// Refuses a field that is not trilinear, not whole or has no samples inside the material
  /// (FieldBuilder::KeepInside), a material all of whose channels other materials are made of too,
  /// and too little memory.
  static Status Make(const ScalarField& field, int material,
                     std::unique_ptr<DrilledField>& drilled);

  /// The band (mm) of the distances that a drilled field on `grid` keeps.
  static double BandOf(const FieldGrid& grid);

  /// Before anything is cut: what `forbidden` has as removed, of the same grid and band as Now(),
  /// is never removed. Samples in it by more than a cell's diagonal and half a side keep their
  /// bits.
  Status Protect(const std::shared_ptr<const RemovedDistances>& forbidden);

  /// Removes what the tool passes. Refuses poses that are not finite, and too little memory, with
  /// that part removed which there was memory for.
  Status Cut(const CutTool& tool, const CutPose& from, const CutPose& to);
  /// The field as it is now; the same object while nothing changes. Refuses too little memory, and
  /// when too many versions are in use (their bricks have room for twice the field's).
  Status MakeVersion(std::shared_ptr<const ScalarField>& version);

  /// What was cut since the last one is a stroke, if it is anything.
  void EndStroke();
  bool CanUndo() const noexcept { return this->Place > 0 || !this->Stroke.IsEmpty(); }
  bool CanRedo() const noexcept
  {
    return this->Stroke.IsEmpty() && this->Place + 1 < this->History.size();
  }
  bool HasOpenStroke() const noexcept { return !this->Stroke.IsEmpty(); }
  /// Each ends a stroke that is not ended, and does nothing where nothing can be undone or redone.
  void Undo();
  void Redo();
  /// Back to the beginning; a step that can be undone.
  void Reset();
  /// The oldest strokes are forgotten, so that they can not be undone, when what they keep takes
  /// more than this. 256 MB by default.
  void SetHistoryBytes(std::size_t bytes);

  /// How much of the material is gone, mm^3. Depends on what is removed alone, to the last bit.
  double RemovedVolume();

  /// What is removed, to be kept (RemovalBytes); ends a stroke that is not ended.
  std::shared_ptr<const RemovedDistances> Removed();
  /// Instead: what was kept earlier of a field of the same samples, but for what is forbidden; a
  /// step that can be undone.
  /// Refuses another grid or band.
  Status Restore(const std::shared_ptr<const RemovedDistances>& removed);

  /// The samples of the channel that is cut as they are now, for each node of the grid, i fastest:
  /// `original` is what the field was built from, `drilled` an array of its type. To types of whole
  /// numbers values are rounded to the nearest one, so that a surface may lie by half a unit of the
  /// value off.
  void WriteSamples(const FieldSamples& original, void* drilled) const;

  int Material() const noexcept { return this->Drilled.Material; }
  int Channel() const noexcept { return this->Drilled.Condition.Channel; }
  /// What of the channel is the material.
  const FieldCondition& Condition() const noexcept { return this->Drilled.Condition; }
  const NodeCut& Law() const noexcept { return this->Drilled.Cut; }
  const RemovedDistances& Now() const noexcept { return this->Stroke.Now(); }
  std::size_t HistoryBytes() const noexcept;
  /// All together.
  std::size_t Bytes() const noexcept;

private:
  // Nodes of a brick that may have changed.
  struct Pending
  {
    std::array<int, 3> Brick;
    NodeBox Nodes;
  };
  DrilledField(std::unique_ptr<EditedField> field, const DrilledMaterial& drilled, double band);

  void MarkNodes(const NodeBox& changed);
  void MarkBrick(const std::array<int, 3>& brick, const NodeBox& changed);
  Status BringUpToDate();
  std::size_t GatherLast();
  bool UpdateBrick(const Pending& pending, std::size_t number);
  bool IsUntouched(const std::array<int, 3>& brick) const noexcept;
  void GoTo(const std::shared_ptr<const RemovedDistances>& state);
  void Push(const std::shared_ptr<const RemovedDistances>& state);
  void ForgetOldest();

  std::unique_ptr<EditedField> Field;
  DrilledMaterial Drilled;
  DrilledBrick Brick;
  DistanceBox Distances;
  DrilledVolume Volume;
  RemovalStroke Stroke;
  std::shared_ptr<const RemovedDistances> Forbidden; // none: all may be removed

  std::vector<NodeBox> Changed; // of the last cut
  std::vector<Pending> Waiting;
  std::vector<std::uint32_t> PlaceOf; // of a brick among what waits
  bool IsUndone = false;              // so that some bricks may be as in the beginning

  std::vector<std::shared_ptr<const RemovedDistances>> History;
  std::size_t Place = 0; // in it
  std::size_t MostHistoryBytes;
};
} // namespace palpate
