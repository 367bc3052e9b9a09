#include "CorrectionPanel.h"

#include "CorrectionFiles.h"
#include "ModelFile.h"
#include "PlainLabel.h"
#include "SceneLabels.h"
#include "ScreenString.h"
#include "SegmentationFile.h"
#include "SoftwareVersions.h"
#include "StudyStructures.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QMenu>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <memory>
#include <utility>

namespace palpate
{
namespace
{
constexpr double SmoothedBy = 1.0;   // mm
constexpr int LongestSentence = 120; // letters

struct CutSide
{
  const char* Text;
  Vector3 Normal; // LPS
};

std::array<CutSide, 6> CutSides()
{
  return {{{"Above the crosshair", Vector3::UnitZ()},
           {"Below the crosshair", -Vector3::UnitZ()},
           {"Left of the crosshair (patient)", Vector3::UnitX()},
           {"Right of the crosshair (patient)", -Vector3::UnitX()},
           {"In front of the crosshair", -Vector3::UnitY()},
           {"Behind the crosshair", Vector3::UnitY()}}};
}

// What `palpate correct` does to the file of a structure.
std::pair<CorrectedOrgan, CorrectionInputs> CorrectedOf(const SceneStructure& structure,
                                                        const StudyCorrection& correction,
                                                        LeftHandedAxes leftHanded)
{
  CorrectionInputs inputs{structure.File, {}, correction.Neighbors};
  if (structure.Source() == SceneSource::Model)
  {
    return {CorrectedOrgan::OfModel(ReadModel(structure.File), correction.Steps), inputs};
  }
  const Segmentation labels = ReadSegmentation(structure.File, leftHanded);
  inputs.Structure = SegmentOf(structure, labels);
  return {CorrectedOrgan::OfMask(labels, *inputs.Structure, correction.Steps, correction.Neighbors),
          inputs};
}
} // namespace

CorrectionPanel::CorrectionPanel(StudyController& study, CorrectionLink& link, BrushLink& brush,
                                 const FileQuestions& questions, const ViewContents& contents,
                                 QWidget* parent)
    : QWidget(parent), Study(study), Link(link), Brush(brush), Questions(questions),
      Contents(contents), Structure(new QComboBox(this)), Tool(new QComboBox(this)),
      Width(new QDoubleSpinBox(this)), TwoWidths(new QCheckBox("Two widths", this)),
      Edges(new QCheckBox("Keep to edges", this)), Neighbors(new QComboBox(this)),
      Back(this->MakeButton("Take back", "correct-back",
                            "Takes the last step back, to the very first one",
                            [this] { this->TakeLastBack(); })),
      Cut(new QPushButton("Cut", this)), Slices(new QPushButton("Slices", this)),
      Keeping(new QPushButton("Keep...", this)),
      Line(new SentenceLabel("correct-line", LongestSentence, this)),
      KeptLine(MakePlainLabel("correct-kept", this)),
      Job(new PanelJob(study, this->Keeping, this->KeptLine, this))
{
  this->MakeChoices();
  this->MakeTools();
  this->MakeNeighbors();
  this->MakeCuts();
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(4, 2, 4, 2);
  column->setSpacing(2);
  column->addWidget(this->Line);
  column->addWidget(this->KeptLine);
  column->addWidget(this->MakeButtons());
  column->addStretch(1);
  connect(this->Job, &PanelJob::Asked, this, &CorrectionPanel::Keep);
  connect(this->Job, &PanelJob::Changed, this,
          [this] { this->KeptLine->setVisible(!this->KeptLine->text().isEmpty()); });
  this->Job->End({});
  connect(&study, &StudyController::StateChanged, this, &CorrectionPanel::ShowState);
  connect(&link, &CorrectionLink::WidthChanged, this, &CorrectionPanel::ShowWidth);
  connect(&brush, &BrushLink::Changed, this, &CorrectionPanel::ShowWidth);
  connect(&brush, &BrushLink::Changed, this, &CorrectionPanel::ShowState);
  this->ShowWidth();
  this->ShowState();
}

QPushButton* CorrectionPanel::MakeButton(const QString& text, const char* name, const QString& tip,
                                         std::function<void()> act)
{
  auto* button = new QPushButton(text, this);
  button->setObjectName(name);
  button->setToolTip(tip);
  connect(button, &QPushButton::clicked, this, std::move(act));
  return button;
}

void CorrectionPanel::MakeChoices()
{
  this->Structure->setObjectName("correct-structure");
  this->Structure->setAccessibleName("Structure to correct");
  this->Structure->setToolTip("A label of a mask, whose voxels are corrected, or a model");
  this->Structure->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  this->Structure->setMinimumContentsLength(10);
  connect(this->Structure, QOverload<int>::of(&QComboBox::activated), this,
          [this](int row) { this->Link.Choose(this->Ids.at(static_cast<std::size_t>(row))); });
  this->Width->setObjectName("correct-width");
  this->Width->setDecimals(1);
  this->Width->setSuffix(" mm");
  this->Width->setToolTip("How far along the surface a pull reaches (standard deviation), or the "
                          "brush's radius; also by the wheel, where a ring shows it");
  connect(this->Width, qOverload<double>(&QDoubleSpinBox::valueChanged), this,
          [this](double width)
          {
            if (this->IsPulling())
            {
              this->Link.SetWidth({width, this->Link.Width().HasTwo});
            }
            else
            {
              this->Brush.SetRadius(width);
            }
          });
  this->TwoWidths->setObjectName("correct-two");
  this->TwoWidths->setToolTip(
      "The mean of this width and 2.2 times it, for errors that are neither "
      "narrow nor wide");
  connect(this->TwoWidths, &QCheckBox::toggled, this,
          [this](bool isOn) {
            this->Link.SetWidth({this->Link.Width().Width, isOn});
          });
}

void CorrectionPanel::MakeTools()
{
  this->Tool->setObjectName("correct-tool");
  this->Tool->setAccessibleName("What a drag does");
  this->Tool->addItems({"Pull", "Paint", "Erase"});
  this->Tool->setToolTip(
      "A drag pulls the surface, or paints (B) or erases (Shift+B) with a brush: "
      "a disc in slices, a ball at the surface in 3-D. Ctrl does the other of "
      "the two; Shift and the wheel scroll");
  connect(this->Tool, QOverload<int>::of(&QComboBox::activated), this,
          [this](int row) { this->Brush.SetTool(static_cast<CorrectionTool>(row)); });
  this->Edges->setObjectName("correct-edges");
  this->Edges->setToolTip("The brush takes only what is joined to the stroke's start and has "
                          "values of the volume like those there");
  connect(this->Edges, &QCheckBox::toggled, this,
          [this](bool isOn) { this->Brush.SetKeepsToEdges(isOn); });
  this->Slices->setObjectName("correct-slices");
  this->Slices->setToolTip("Copies the outline to the slice before or after, or fills between the "
                           "two slices that were painted last");
  auto* menu = new QMenu(this->Slices);
  menu->addActions(this->Brush.SliceActions());
  this->Slices->setMenu(menu);
}

void CorrectionPanel::MakeNeighbors()
{
  this->Neighbors->setObjectName("correct-neighbors");
  this->Neighbors->addItems({"Stop at others", "Overlap others", "Overwrite others"});
  this->Neighbors->setAccessibleName("What a pull does at another structure");
  this->Neighbors->setToolTip("At voxels of other structures a pull ends, or they belong to both "
                              "structures, or are taken from the others");
  connect(this->Neighbors, QOverload<int>::of(&QComboBox::activated), this,
          [this](int chosen)
          {
            StudyState next = this->Study.State();
            next.Correction.Neighbors = static_cast<NeighborPolicy>(chosen);
            this->Study.Change("Change what neighbours do", next);
          });
}

void CorrectionPanel::MakeCuts()
{
  this->Cut->setObjectName("correct-cut");
  this->Cut->setToolTip("Removes what lies beyond a plane through the crosshair");
  auto* menu = new QMenu(this->Cut);
  for (const CutSide& side : CutSides())
  {
    menu->addAction(side.Text, this, [this, normal = side.Normal] { this->CutBeyond(normal); });
  }
  this->Cut->setMenu(menu);
}

QWidget* CorrectionPanel::MakeButtons()
{
  auto* mode = new QPushButton("Push and pull (G)", this);
  mode->setObjectName("correct-mode");
  mode->setCheckable(true);
  connect(mode, &QPushButton::toggled, this->Link.Mode(), &QAction::setChecked);
  connect(this->Link.Mode(), &QAction::toggled, mode, &QPushButton::setChecked);
  this->Edits = {this->MakeButton("Islands", "correct-islands",
                                  "Removes all but the mask's largest part",
                                  [this] { this->Link.Do(IslandRemoval{}); }),
                 this->MakeButton("Fill", "correct-fill", "Fills cavities that the mask encloses",
                                  [this] { this->Link.Do(CavityFilling{}); }),
                 this->MakeButton("Smooth", "correct-smooth",
                                  "Smooths the mask's surface by 1 mm; its volume stays",
                                  [this] { this->Link.Do(SurfaceSmoothing{SmoothedBy}); }),
                 this->Cut, this->Slices};
  this->Keeping->setObjectName("correct-keep");
  this->Keeping->setToolTip("Writes the corrected mask or model to a folder, with the steps, and "
                            "makes it a structure of that name; the source stays as it is");
  auto* buttons = new QWidget(this);
  auto* grid = new QGridLayout(buttons);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setSpacing(2);
  grid->addWidget(mode, 0, 0);
  grid->addWidget(this->Structure, 0, 1);
  grid->addWidget(this->Neighbors, 0, 2);
  grid->addWidget(this->Tool, 1, 0);
  grid->addWidget(this->Width, 1, 1);
  grid->addWidget(this->TwoWidths, 1, 2);
  grid->addWidget(this->Edges, 1, 2);
  auto* edits = new QHBoxLayout;
  edits->setSpacing(2);
  for (QPushButton* edit : this->Edits)
  {
    edits->addWidget(edit);
  }
  grid->addLayout(edits, 2, 0, 1, 3);
  grid->addWidget(this->MakeButton("Discard", "correct-discard",
                                   "Gives up the correction; that can be undone",
                                   [this] { this->Link.Choose(0); }),
                  3, 0);
  grid->addWidget(this->Back, 3, 1);
  grid->addWidget(this->Keeping, 3, 2);
  for (int column = 0; column < 3; ++column)
  {
    grid->setColumnStretch(column, 1);
  }
  return buttons;
}

void CorrectionPanel::ShowState()
{
  const StudyCorrection& correction = this->Study.State().Correction;
  StudyCorrected& corrected = this->Study.Current().Corrected();
  this->ShowStructures();
  this->Neighbors->setCurrentIndex(static_cast<int>(correction.Neighbors));
  const bool isThere = corrected.Pulls() != nullptr;
  for (QPushButton* edit : this->Edits)
  {
    edit->setEnabled(isThere && corrected.IsMask());
  }
  this->Neighbors->setEnabled(!isThere || corrected.IsMask());
  this->Back->setEnabled(!correction.Steps.empty());
  const bool isDone =
      !correction.Steps.empty() && corrected.IsReady() && corrected.Problem().empty();
  this->Keeping->setEnabled(isDone || this->Job->IsRunning());
  this->Line->Say(this->Sentence());
}

void CorrectionPanel::ShowStructures()
{
  std::vector<int> ids{0};
  QStringList names{"Nothing"};
  for (const SceneStructure& structure : this->Study.State().Structures)
  {
    if (StudyCorrected::IsCorrectable(structure))
    {
      ids.push_back(structure.Id);
      names += ScreenString(TitleOf(structure));
    }
  }
  QStringList shown;
  for (int row = 0; row < this->Structure->count(); ++row)
  {
    shown += this->Structure->itemText(row);
  }
  if (names != shown)
  {
    this->Structure->clear();
    this->Structure->addItems(names);
  }
  this->Ids = ids;
  const auto chosen = std::find(ids.begin(), ids.end(), this->Study.State().Correction.StructureId);
  this->Structure->setCurrentIndex(chosen != ids.end() ? static_cast<int>(chosen - ids.begin())
                                                       : 0);
}

void CorrectionPanel::ShowWidth()
{
  const QSignalBlocker quiet(this->Width);
  const bool pulls = this->IsPulling();
  this->Tool->setCurrentIndex(static_cast<int>(this->Brush.Tool()));
  this->Width->setPrefix(pulls ? "Width " : "Radius ");
  this->Width->setRange(pulls ? PullWidth::Least : BrushLink::LeastRadius,
                        pulls ? PullWidth::Largest : BrushLink::LargestRadius);
  this->Width->setValue(pulls ? this->Link.Width().Width : this->Brush.Radius());
  this->TwoWidths->setVisible(pulls);
  this->Edges->setVisible(!pulls);
  this->TwoWidths->setChecked(this->Link.Width().HasTwo);
}

QString CorrectionPanel::Sentence() const
{
  StudyCorrected& corrected = this->Study.Current().Corrected();
  const std::size_t count = this->Study.State().Correction.Steps.size();
  if (!corrected.Problem().empty())
  {
    return "Refused: " + ScreenString(corrected.Problem()) + ".";
  }
  if (this->Study.State().Correction.StructureId == 0)
  {
    return "Choose Push and pull (G), then drag a structure's surface in a slice or in 3-D.";
  }
  if (!corrected.IsReady())
  {
    return "Working...";
  }
  if (count == 0 && !this->IsPulling())
  {
    return "Paint in a slice or at the surface in 3-D; Ctrl erases, the wheel sets the radius.";
  }
  if (count == 0)
  {
    return "Drag the surface: outwards pulls, inwards pushes. The wheel over it sets the width.";
  }
  const QString steps = QString("%1 step%2").arg(count).arg(count == 1 ? "" : "s");
  const CorrectionChange* change = corrected.Change();
  if (change == nullptr)
  {
    return steps + "; the change is being measured...";
  }
  const double milliliters = change->Milliliters - change->StartMilliliters;
  return QString("%1: %2%3 ml of %4, Dice with the start %5, on average %6 mm, at most %7 mm.")
      .arg(steps, milliliters < 0.0 ? "\u2212" : "+")
      .arg(std::abs(milliliters), 0, 'f', 2)
      .arg(change->StartMilliliters, 0, 'f', 2)
      .arg(change->Dice, 0, 'f', 3)
      .arg(change->MeanDistance, 0, 'f', 2)
      .arg(change->LargestDistance, 0, 'f', 1);
}

void CorrectionPanel::CutBeyond(const Vector3& normal)
{
  this->Link.Do(PlaneCut{Vector3(this->Contents.Crosshair()->GetPositionWorld()), normal});
}

void CorrectionPanel::TakeLastBack()
{
  StudyState next = this->Study.State();
  next.Correction.Steps.pop_back();
  this->Study.Change("Take the last step back", next);
}

void CorrectionPanel::Keep()
{
  const StudyState& state = this->Study.State();
  const SceneStructure* structure = FindStructure(state, state.Correction.StructureId);
  const QString chosen = structure != nullptr
                             ? this->Questions.Folder(this, "Folder for the result, and its name")
                             : QString();
  if (chosen.isEmpty())
  {
    return;
  }
  const std::filesystem::path folder = StudyPath(chosen.toStdString());
  this->Job->Run(
      [this, folder, structure = *structure, correction = state.Correction,
       leftHanded = state.LeftHanded](const ProgressFunction&)
      {
        const auto [organ, inputs] = CorrectedOf(structure, correction, leftHanded);
        WriteCorrectionFiles(organ, inputs, folder,
                             "palpate-viewer " + SoftwareVersions().front().second);
        return [this, folder, correction, file = folder / CorrectedFileOf(organ, inputs)]
        {
          const std::string name = folder.filename().string();
          StudyState next = WithKeptCorrection(this->Study.State(), name, file);
          if (this->Study.State().Correction == correction) // it did not go on meanwhile
          {
            this->Study.Change("Keep " + ScreenString(name), next);
          }
          this->Job->End("Kept in " + ScreenString(folder.string()) + ".");
        };
      });
}
} // namespace palpate
