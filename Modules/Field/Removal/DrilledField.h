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
/// A field from which tools remove one material: cuts are grouped into strokes, which can be
/// undone. Versions are immutable; any thread may use them for any time while further cuts are
/// made. A version is the field that FieldBuilder would build from the current samples: hits and
/// inside tests have the same bits.
///
/// Cuts change one channel, which no other material may use. So a structure that must not be
/// removed needs a material with its own channel, or a label that limits this one.
///
/// Owner thread only. Allocates: not for the servo thread.
class DrilledField
{
public:
  /// Fails for a field that is not trilinear, not whole or has no samples inside the material
  /// (FieldBuilder::KeepInside), for a material all of whose channels are also used by others, and
  /// for insufficient memory.
  static Status Make(const ScalarField& field, int material,
                     std::unique_ptr<DrilledField>& drilled);

  /// The distance band (mm) of a drilled field on `grid`.
  static double BandOf(const FieldGrid& grid);

  /// Before the first cut: the volume removed in `forbidden`, which must have the grid and band of
  /// Now(), is never removed. Samples deeper in it than a cell's diagonal plus half a side keep
  /// their bits.
  Status Protect(const std::shared_ptr<const RemovedDistances>& forbidden);

  /// Removes the volume that the tool sweeps. Fails for poses that are not finite, and for
  /// insufficient memory, with only the part removed for which memory sufficed.
  Status Cut(const CutTool& tool, const CutPose& from, const CutPose& to);
  /// The current field; the same object while nothing changes. Fails for insufficient memory, and
  /// if too many versions are in use (their bricks have room for twice the field's).
  Status MakeVersion(std::shared_ptr<const ScalarField>& version);

  /// Ends the stroke of all cuts since the last call, unless it is empty.
  void EndStroke();
  bool CanUndo() const noexcept { return this->Place > 0 || !this->Stroke.IsEmpty(); }
  bool CanRedo() const noexcept
  {
    return this->Stroke.IsEmpty() && this->Place + 1 < this->History.size();
  }
  bool HasOpenStroke() const noexcept { return !this->Stroke.IsEmpty(); }
  /// Each ends an open stroke, and does nothing if there is nothing to undo or redo.
  void Undo();
  void Redo();
  /// Restores the initial state; can be undone.
  void Reset();
  /// Discards the oldest strokes, which then cannot be undone, if the history takes more memory
  /// than this. 256 MB by default.
  void SetHistoryBytes(std::size_t bytes);

  /// Removed volume of the material, mm^3. Depends on the removed region alone, to the last bit.
  double RemovedVolume();

  /// The removed region, to be saved (RemovalBytes); ends an open stroke.
  std::shared_ptr<const RemovedDistances> Removed();
  /// Replaces the removed region by one saved from a field with the same samples, except for the
  /// forbidden region; can be undone. Fails for another grid or band.
  Status Restore(const std::shared_ptr<const RemovedDistances>& removed);

  /// The current samples of the channel that is cut, for each node of the grid, i fastest:
  /// `original` is the source of the field, `drilled` an array of its type. For integer types
  /// values are rounded to the nearest one, so that a surface may be off by half a unit of the
  /// value.
  void WriteSamples(const FieldSamples& original, void* drilled) const;

  int Material() const noexcept { return this->Drilled.Material; }
  int Channel() const noexcept { return this->Drilled.Condition.Channel; }
  /// The material's condition on the channel that is cut.
  const FieldCondition& Condition() const noexcept { return this->Drilled.Condition; }
  const NodeCut& Law() const noexcept { return this->Drilled.Cut; }
  const RemovedDistances& Now() const noexcept { return this->Stroke.Now(); }
  std::size_t HistoryBytes() const noexcept;
  /// Total.
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
  std::shared_ptr<const RemovedDistances> Forbidden; // none: everything may be removed

  std::vector<NodeBox> Changed; // of the last cut
  std::vector<Pending> Waiting;
  std::vector<std::uint32_t> PlaceOf; // of a brick in the pending list
  bool IsUndone = false;              // some bricks may be in their initial state

  std::vector<std::shared_ptr<const RemovedDistances>> History;
  std::size_t Place = 0; // in the history
  std::size_t MostHistoryBytes;
};
} // namespace palpate
