#pragma once

#include "SlicePane.h"
#include "SpacePane.h"
#include "ViewContents.h"

#include "vtkImageData.h"

#include <QGridLayout>
#include <QWidget>

#include <array>
#include <set>
#include <string>

namespace palpate
{
/// How the views of a window lie.
enum class ViewLayout
{
  Four,  ///< two by two
  Space, ///< the view in space, and slices beside it
  One    ///< one alone
};
constexpr std::array<ViewLayout, 3> AllViewLayouts{
    {ViewLayout::Four, ViewLayout::Space, ViewLayout::One}};

/// "four", "space", "one": as sessions name them.
const char* WordOf(ViewLayout layout);
/// The first one for an unknown word.
ViewLayout LayoutOf(const std::string& word);

/// Three slices and the view in space, linked by what they share.
class ViewGrid : public QWidget
{
  Q_OBJECT

public:
  /// Shows `contents`, which outlive it.
  explicit ViewGrid(ViewContents& contents, QWidget* parent = nullptr);

  SlicePane* Slice(SliceOrientation orientation) const
  {
    return this->Slices[static_cast<std::size_t>(orientation)];
  }
  SpacePane* Space() const { return this->InSpace; }
  const std::array<ViewPane*, 4>& Panes() const { return this->All; }

  void SetLayout(ViewLayout layout);
  ViewLayout Layout() const { return this->Shown; }
  /// One view alone, and back again.
  void ToggleMaximized(ViewPane* pane);
  ViewPane* Maximized() const { return this->Alone; }

  /// Takes over surfaces and fields that the contents show by now.
  void TakeContents();
  void SetAlongImage(bool isAlongImage);
  void SetLeftButtonMode(int mode);
  void FitAll();

private:
  void Arrange();
  void FitToAnotherImage();
  void Put(ViewPane* pane, int row, int column, int rows, int columns);

  ViewContents& Contents;
  std::array<SlicePane*, 3> Slices{};
  SpacePane* InSpace;
  std::array<ViewPane*, 4> All{};
  QGridLayout* Grid;
  ViewLayout Shown = ViewLayout::Four;
  ViewPane* Alone = nullptr;
  ViewPane* One; ///< of that layout
  std::set<vtkSmartPointer<vtkSurfaceDisplay>> Surfaces;
  vtkSmartPointer<vtkImageData> Image; ///< that the views were fitted to
};
} // namespace palpate
