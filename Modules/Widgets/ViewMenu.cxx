#include "ViewMenu.h"

#include "OpenGLDriver.h"
#include "Preferences.h"
#include "ToolIcon.h"
#include "ViewPicture.h"

#include <QActionGroup>
#include <QApplication>
#include <QClipboard>
#include <QSettings>

#include <algorithm>

namespace palpate
{
ViewMenu::ViewMenu(StudyController& study, const FileQuestions& questions, ViewGrid& views,
                   ViewContents& contents, QWidget* window)
    : QMenu("&View", window), Study(study), Questions(questions), Views(views), Contents(contents)
{
  this->AddLayouts();
  this->AddMouse();
  this->AddContents();
  this->AddCameras();
  this->AddPictures();
  connect(&study, &StudyController::StateChanged, this, &ViewMenu::ShowView);
  connect(&study, &StudyController::ViewChanged, this, &ViewMenu::ShowView);
  this->ShowView();
}

void ViewMenu::AddLayouts()
{
  constexpr std::array<const char*, 3> Texts{"&Four views", "&3-D with slices", "&One view"};
  auto* group = new QActionGroup(this);
  auto* choice = new QMenu("Layout", this); // of the toolbar
  choice->setIcon(ToolIcon(ToolSign::Layout));
  this->ForTools += choice->menuAction();
  for (const ViewLayout layout : AllViewLayouts)
  {
    const auto l = static_cast<std::size_t>(layout);
    this->Layouts[l] = this->addAction(Texts[l]);
    this->Layouts[l]->setCheckable(true);
    this->Layouts[l]->setShortcut(QString("Ctrl+%1").arg(l + 1));
    group->addAction(this->Layouts[l]);
    choice->addAction(this->Layouts[l]);
    connect(this->Layouts[l], &QAction::triggered, this,
            [this, layout]
            {
              this->Views.SetLayout(layout);
              StudyView view = this->Study.State().View;
              view.Layout = WordOf(layout);
              this->Study.ChangeView(view);
            });
  }
  this->addSeparator();
}

void ViewMenu::AddMouse()
{
  QAction* windowLevel = this->WindowLevel =
      this->addAction("Adjust &window and level by left drag");
  windowLevel->setCheckable(true);
  windowLevel->setShortcut(QString("W"));
  windowLevel->setIcon(ToolIcon(ToolSign::WindowLevel));
  connect(windowLevel, &QAction::toggled, this,
          [this](bool isOn)
          {
            this->Views.SetLeftButtonMode(isOn ? vtkInteractorStyleSlice::WINDOW_LEVEL
                                               : vtkInteractorStyleSlice::CROSSHAIR);
          });
  this->addAction(
      "&Reset window and level", this, [this] { this->Contents.Images()->ResetWindowLevel(); },
      QKeySequence("Shift+W"));
  this->addAction(
      "Next &volume over the first", this,
      [this] { this->Study.Change("Show the next volume", WithNextVolume(this->Study.State())); },
      QKeySequence("Shift+N"));
  QAction* fit = this->addAction(
      "Fit &all views", this, [this] { this->Views.FitAll(); }, QKeySequence("Ctrl+R"));
  fit->setIcon(ToolIcon(ToolSign::Fit));
  this->ForTools += {windowLevel, fit};
  this->addSeparator();
}

QAction* ViewMenu::AddSwitch(const QString& text, const QKeySequence& key, bool StudyView::*field)
{
  QAction* action = this->addAction(text);
  action->setCheckable(true);
  action->setShortcut(key);
  connect(action, &QAction::triggered, this,
          [this, field](bool isOn)
          {
            StudyView view = this->Study.State().View;
            view.*field = isOn;
            this->Study.ChangeView(view);
          });
  return action;
}

void ViewMenu::AddContents()
{
  this->AlongImage = this->AddSwitch("Slices along the &volume's axes", QKeySequence("Ctrl+M"),
                                     &StudyView::UsesVolumeAxes);
  this->FollowProbe = this->AddSwitch("Slices follow the &probe", QKeySequence("Ctrl+F"),
                                      &StudyView::SlicesFollowProbe);
  this->ErrorMaps = this->addAction("All as &error maps");
  this->ErrorMaps->setCheckable(true);
  this->ErrorMaps->setShortcut(QString("Ctrl+E"));
  connect(this->ErrorMaps, &QAction::triggered, this, &ViewMenu::ShowErrorMaps);
  this->AddErrorScales();
  QAction* slices = this->addAction("Slices in &3-D");
  slices->setCheckable(true);
  slices->setShortcut(QString("Shift+D"));
  connect(slices, &QAction::toggled, this->Views.Space(), &SpacePane::ShowSlices);
  QAction* smooth = this->addAction("&Smooth slices");
  smooth->setCheckable(true);
  smooth->setChecked(true);
  connect(smooth, &QAction::toggled, this,
          [this](bool isOn) { this->Contents.Images()->SetInterpolate(isOn); });
  this->AddQuality();
  this->addSeparator();
}

// A setting of the machine, not of a study.
void ViewMenu::AddQuality(const QString& text, const QString& key, bool isDefault,
                          void (SpacePane::*apply)(bool))
{
  QAction* action = this->addAction(text);
  action->setCheckable(true);
  action->setChecked(QSettings().value(key, isDefault).toBool());
  // An action that is off at first tells nothing, and the view may begin with it on.
  (this->Views.Space()->*apply)(action->isChecked());
  connect(action, &QAction::toggled, this->Views.Space(), apply);
  connect(action, &QAction::toggled, this, [key](bool isOn) { QSettings().setValue(key, isOn); });
}

// Without a graphics card what costs frames waits for a rest.
void ViewMenu::AddQuality()
{
  this->Views.Space()->WaitForRest(!IsGraphicsCard(OpenGLDriver()));
  this->AddGrounds();
  this->AddQuality("Smooth ed&ges in 3-D", "smooth-edges", true, &SpacePane::SmoothEdges);
  this->AddQuality("S&hadow of the tool in 3-D", "tool-shadow", true, &SpacePane::ShowToolShadow);
  this->AddQuality("Am&bient occlusion in 3-D", "ambient-occlusion", true,
                   &SpacePane::ShowOcclusion);
}

void ViewMenu::AddGrounds()
{
  constexpr std::array<const char*, 4> Texts{"As the &theme", "&Dark", "&Light",
                                             "&White, for print"};
  constexpr const char* Key = "ground";
  QMenu* menu = this->addMenu("Back&ground of 3-D");
  auto* group = new QActionGroup(this);
  const ViewGround kept = ViewGroundOf(QSettings().value(Key).toString());
  this->Views.Space()->SetGround(kept);
  for (const ViewGround ground : AllViewGrounds)
  {
    QAction* action = menu->addAction(Texts[static_cast<std::size_t>(ground)]);
    action->setCheckable(true);
    action->setChecked(ground == kept);
    group->addAction(action);
    connect(action, &QAction::triggered, this,
            [this, ground, Key]
            {
              this->Views.Space()->SetGround(ground);
              QSettings().setValue(Key, NameOf(ground));
            });
  }
}

void ViewMenu::AddPictures()
{
  this->addSeparator();
  QMenu* copies = this->addMenu("Copy &image");
  QMenu* files = this->addMenu("Sa&ve image \u00D72, white background");
  for (ViewPane* pane : this->Views.Panes())
  {
    const auto copy = [this, pane] { this->CopyPicture(*pane); };
    const auto save = [this, pane] { this->SavePicture(*pane); };
    copies->addAction(pane->Name(), this, copy);
    files->addAction(pane->Name(), this, save);
    pane->AddToHeader("Copy image", copy);
    pane->AddToHeader("Save image \u00D72, white background...", save);
  }
}

void ViewMenu::CopyPicture(ViewPane& pane) const
{
  const QSize size = pane.devicePixelRatioF() * pane.Canvas()->size();
  QApplication::clipboard()->setImage(PictureOf(pane, size, PictureGround::AsShown));
}

void ViewMenu::SavePicture(ViewPane& pane)
{
  constexpr double Enlargement = 2.0; // for print
  QString file = this->Questions.ToSave(this->window(), "Save the image",
                                        pane.objectName() + ".png", "Images (*.png)");
  if (!file.isEmpty())
  {
    file += file.endsWith(".png", Qt::CaseInsensitive) ? "" : ".png";
    const QSize size = Enlargement * pane.devicePixelRatioF() * pane.Canvas()->size();
    this->Study.Write(file.toStdString(), [picture = PictureOf(pane, size, PictureGround::White),
                                           file](const ProgressFunction&)
                      { WritePicture(picture, file.toStdString()); });
  }
}

void ViewMenu::AddErrorScales()
{
  QMenu* menu = this->addMenu("Scale of error &maps");
  auto* group = new QActionGroup(this);
  for (const std::optional<double>& scale : palpate::ErrorScales)
  {
    QAction* action = menu->addAction(TextOf(scale));
    action->setCheckable(true);
    group->addAction(action);
    this->ErrorScales.emplace_back(action, scale);
    connect(action, &QAction::triggered, this,
            [this, scale]
            {
              StudyView view = this->Study.State().View;
              view.ErrorScale = scale;
              this->Study.ChangeView(view);
            });
  }
}

void ViewMenu::AddCameras()
{
  constexpr std::array<const char*, 6> Names{"Anterior", "Posterior", "Left",
                                             "Right",    "Superior",  "Inferior"};
  QMenu* cameras = this->addMenu("&Look from");
  for (std::size_t side = 0; side < Names.size(); ++side)
  {
    QAction* action = cameras->addAction(Names[side]);
    action->setShortcut(QString("Alt+%1").arg(Names[side][0]));
    connect(action, &QAction::triggered, this,
            [this, side] { this->Views.Space()->LookFrom(static_cast<int>(side)); });
  }
}

// Switches all visible structures in one undo step, and back to their previous display.
void ViewMenu::ShowErrorMaps(bool areShown)
{
  StudyState next = this->Study.State();
  for (SceneStructure& structure : next.Structures)
  {
    const bool isErrorMap = structure.Appearance == SceneAppearance::ErrorMap;
    if (!structure.IsVisible || isErrorMap == areShown)
    {
      continue;
    }
    const auto before = this->Before.find(structure.Id);
    const bool isKnown = before != this->Before.end();
    const SceneAppearance former = isKnown ? before->second : SceneAppearance::Automatic;
    if (areShown)
    {
      this->Before[structure.Id] = structure.Appearance;
    }
    structure.Appearance = areShown ? SceneAppearance::ErrorMap : former;
  }
  this->Study.Change(areShown ? "Show all as error maps" : "Show no error maps", next);
  this->ShowView();
}

void ViewMenu::ShowView()
{
  const auto& all = this->Study.State().Structures;
  const auto isOther = [](const SceneStructure& structure)
  { return structure.IsVisible && structure.Appearance != SceneAppearance::ErrorMap; };
  const auto isSeen = [](const SceneStructure& structure) { return structure.IsVisible; };
  this->ErrorMaps->setChecked(std::any_of(all.begin(), all.end(), isSeen) &&
                              std::none_of(all.begin(), all.end(), isOther));
  const StudyView& view = this->Study.State().View;
  const ViewLayout layout = LayoutOf(view.Layout);
  if (this->Views.Layout() != layout)
  {
    this->Views.SetLayout(layout);
  }
  this->Layouts[static_cast<std::size_t>(layout)]->setChecked(true);
  this->AlongImage->setChecked(view.UsesVolumeAxes);
  this->FollowProbe->setChecked(view.SlicesFollowProbe);
  for (const auto& [action, scale] : this->ErrorScales)
  {
    action->setChecked(view.ErrorScale == scale);
  }
  this->Views.SetAlongImage(view.UsesVolumeAxes);
}
} // namespace palpate
