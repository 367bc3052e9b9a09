#pragma once

#include "FileQuestions.h"
#include "StudyController.h"
#include "ViewGrid.h"

#include <QMenu>

#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace palpate
{
/// Layouts, contents, looks and cameras of views, pictures of them, and mouse modes.
class ViewMenu : public QMenu
{
  Q_OBJECT

public:
  /// Keeps the addresses.
  ViewMenu(StudyController& study, const FileQuestions& questions, ViewGrid& views,
           ViewContents& contents, QWidget* window);

  /// What a left drag on slices does.
  void AdjustWindowByLeftDrag(bool isOn) { this->WindowLevel->setChecked(isOn); }
  /// Those for the toolbar.
  const QList<QAction*>& Tools() const { return this->ForTools; }

private:
  void AddLayouts();
  void AddCameras();
  void AddMouse();
  void AddContents();
  void AddErrorScales();
  void AddGrounds();
  void AddPictures();
  void CopyPicture(ViewPane& pane) const;
  void SavePicture(ViewPane& pane);
  void AddQuality();
  void AddQuality(const QString& text, const QString& key, bool isDefault,
                  void (SpacePane::*apply)(bool));
  void ShowView();
  void ShowErrorMaps(bool areShown);
  /// Adds a switch for a field of the view's state.
  QAction* AddSwitch(const QString& text, const QKeySequence& key, bool StudyView::*field);

  StudyController& Study;
  const FileQuestions& Questions;
  ViewGrid& Views;
  ViewContents& Contents;
  std::array<QAction*, 3> Layouts{};
  QAction* WindowLevel = nullptr;
  QAction* AlongImage = nullptr;
  QAction* FollowProbe = nullptr;
  QAction* ErrorMaps = nullptr;
  std::vector<std::pair<QAction*, std::optional<double>>> ErrorScales;
  QList<QAction*> ForTools;
  std::map<int, SceneAppearance> Before; ///< by label, of structures that became error maps here
};
} // namespace palpate
