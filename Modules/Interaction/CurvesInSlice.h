#pragma once

#include "CurveActor.h"

#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <memory>
#include <vector>

namespace palpate
{
/// Curves that a slice view draws of what it shows, one actor each; `Cut` is what the last curves
/// of one were made from, so that they are made again only if that changed.
template <typename Shown, typename Cut>
class CurvesInSlice
{
public:
  /// Null removes them.
  void SetRenderer(vtkRenderer* renderer)
  {
    for (const Entry& entry : this->Entries)
    {
      Take(entry, this->Renderer);
      Give(entry, renderer);
    }
    this->Renderer = renderer;
  }
  void Add(Shown* shown)
  {
    this->Entries.push_back({shown, std::make_unique<CurveActor>(), {}});
    Give(this->Entries.back(), this->Renderer);
  }
  void Remove(Shown* shown)
  {
    const auto gone = std::stable_partition(this->Entries.begin(), this->Entries.end(),
                                            [shown](const Entry& one) { return one.Of != shown; });
    std::for_each(gone, this->Entries.end(),
                  [this](const Entry& entry) { Take(entry, this->Renderer); });
    this->Entries.erase(gone, this->Entries.end());
  }

  /// Number of cuts so far.
  int CutCount() const { return this->Cuts; }

protected:
  struct Entry
  {
    vtkSmartPointer<Shown> Of;
    std::unique_ptr<CurveActor> Curves;
    Cut Last;
  };

  std::vector<Entry> Entries;
  int Cuts = 0;

private:
  static void Give(const Entry& entry, vtkRenderer* renderer)
  {
    if (renderer != nullptr)
    {
      renderer->AddViewProp(entry.Curves->Actor());
    }
  }
  static void Take(const Entry& entry, vtkRenderer* renderer)
  {
    if (renderer != nullptr)
    {
      renderer->RemoveViewProp(entry.Curves->Actor());
    }
  }

  vtkSmartPointer<vtkRenderer> Renderer;
};
} // namespace palpate
