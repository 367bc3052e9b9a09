#include "RelationsPanel.h"

#include "DecimalText.h"
#include "RelationFiles.h"
#include "ScreenString.h"
#include "TriangleMesh.h"

#include "vtkPolyData.h"
#include "vtkSurfaceDisplay.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QTabWidget>
#include <QVBoxLayout>

#include <cmath>
#include <utility>

namespace palpate
{
namespace
{
constexpr int PlaceRole = Qt::UserRole; // of a row, in the list of pairs

// Sorted as a number.
QTableWidgetItem* RelationNumber(double number, int digits)
{
  auto* item = new QTableWidgetItem;
  if (std::isfinite(number))
  {
    const double scale = std::pow(10.0, digits);
    item->setData(Qt::DisplayRole, std::round(number * scale) / scale);
  }
  item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
  return item;
}

QTableWidgetItem* RelationWords(const std::string& text)
{
  return new QTableWidgetItem(ScreenString(text));
}
} // namespace

RelationsPanel::RelationsPanel(StudyController& study, ViewContents& contents,
                               const FileQuestions& questions, QWidget* parent)
    : QWidget(parent), Study(study), Contents(contents), Questions(questions),
      Pairs(this->MakeTable("relation-pairs", {"First", "Second", "Lies", "Distance, mm",
                                               "Wall, mm", "Contact, mm²", "Second is"})),
      Shapes(this->MakeTable("relation-shapes",
                             {"Structure", "Volume, ml", "Area, cm²", "Length, mm", "Width, mm",
                              "Depth, mm", "Thickness, mm", "Sphericity"})),
      Measuring(new QPushButton("Measure", this)), Saving(new QPushButton("Save page...", this)),
      Line(new QLabel(this)), Job(new PanelJob(study, this->Measuring, this->Line, this))
{
  this->Measuring->setObjectName("relations-measure");
  this->Saving->setObjectName("relations-save");
  this->Line->setObjectName("relations-line");
  auto* tabs = new QTabWidget(this);
  tabs->addTab(this->Pairs, "Pairs");
  tabs->addTab(this->Shapes, "Shapes");
  auto* buttons = new QVBoxLayout;
  buttons->addWidget(this->Measuring);
  buttons->addWidget(this->Saving);
  buttons->addWidget(this->Line);
  buttons->addStretch(1);
  this->Line->setFixedWidth(18 * this->fontMetrics().averageCharWidth());
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(4, 2, 4, 2);
  row->addWidget(tabs, 1);
  row->addLayout(buttons);
  this->Pairs->horizontalHeader()->setSortIndicator(3, Qt::AscendingOrder); // the nearest first
  this->Shapes->horizontalHeader()->setSortIndicator(0, Qt::AscendingOrder);
  connect(this->Job, &PanelJob::Asked, this, &RelationsPanel::Measure);
  connect(this->Job, &PanelJob::Changed, this,
          [this] { this->Saving->setEnabled(!this->Job->IsRunning() && this->Found != nullptr); });
  connect(this->Saving, &QPushButton::clicked, this, &RelationsPanel::Save);
  connect(this->Pairs, &QTableWidget::cellDoubleClicked, this, &RelationsPanel::ShowPlaceOf);
  this->Job->End("Distances, contact and shapes of the structures that are displayed as surfaces.");
}

QTableWidget* RelationsPanel::MakeTable(const char* name, const QStringList& heads)
{
  auto* table = new QTableWidget(0, static_cast<int>(heads.size()), this);
  table->setObjectName(name);
  table->setHorizontalHeaderLabels(heads);
  table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table->verticalHeader()->hide();
  table->setSelectionBehavior(QAbstractItemView::SelectRows);
  table->setEditTriggers(QAbstractItemView::NoEditTriggers);
  return table;
}

std::vector<NamedSurface> RelationsPanel::Displayed() const
{
  std::vector<NamedSurface> surfaces;
  for (const SceneStructure& structure : this->Study.State().Structures)
  {
    const auto shown = this->Contents.Surfaces().find(structure.Id);
    vtkPolyData* surface =
        shown != this->Contents.Surfaces().end() ? shown->second->GetSurface() : nullptr;
    if (structure.IsVisible && surface != nullptr && surface->GetNumberOfPolys() > 0)
    {
      TriangleMesh mesh = TrianglesOf(surface, TitleOf(structure));
      surfaces.push_back({TitleOf(structure),
                          structure.Color,
                          {std::move(mesh.PointsWorld), std::move(mesh.Triangles)}});
    }
  }
  return surfaces;
}

void RelationsPanel::Measure()
{
  const auto surfaces = std::make_shared<const std::vector<NamedSurface>>(this->Displayed());
  if (surfaces->empty())
  {
    this->Job->End(
        "Nothing is displayed as a surface: show a structure as its model or its surface.");
    return;
  }
  this->Job->Run(
      [this, surfaces](const ProgressFunction& progress)
      {
        auto found =
            std::make_shared<const OrganRelations>(OrganRelations::Of(*surfaces, {}, progress));
        return [this, found] { this->Take(found); };
      });
}

void RelationsPanel::Take(std::shared_ptr<const OrganRelations> found)
{
  this->Found = std::move(found);
  this->FillPairs();
  this->FillShapes();
  const std::string counts = CountText(this->Shapes->rowCount(), "structure", "structures") + ", " +
                             CountText(this->Pairs->rowCount(), "pair", "pairs");
  QString text = QString("%1 within %2 mm; a double click shows where.")
                     .arg(QString::fromStdString(counts))
                     .arg(this->Found->Settings.Reach());
  for (const RelatedOrgan& organ : this->Found->Organs)
  {
    if (!organ.IsMeasured())
    {
      text += "\n" + ScreenString(organ.Name + ": " + organ.Message);
    }
  }
  this->Job->End(text);
}

void RelationsPanel::FillPairs()
{
  this->Pairs->setSortingEnabled(false); // rows would move while they are filled
  this->Pairs->setRowCount(0);
  for (const std::size_t near : this->Found->NearPairs())
  {
    const OrganPair& pair = this->Found->Pairs[near];
    const BodyRelation& relation = pair.Relation;
    const int row = this->Pairs->rowCount();
    this->Pairs->insertRow(row);
    int column = 0;
    for (QTableWidgetItem* item :
         {RelationWords(this->Found->Organs[pair.One].Name),
          RelationWords(this->Found->Organs[pair.Other].Name),
          RelationWords(RelationWord(relation.Is)), RelationNumber(relation.Distance(), 2),
          RelationNumber(relation.Wall.Distance, 2),
          RelationNumber(0.5 * (relation.One.ContactArea + relation.Other.ContactArea), 1),
          RelationWords(OffsetSideOf(relation.Offset).Name)})
    {
      this->Pairs->setItem(row, column++, item);
    }
    this->Pairs->item(row, 0)->setData(PlaceRole, static_cast<int>(near));
  }
  this->Pairs->setSortingEnabled(true);
}

void RelationsPanel::FillShapes()
{
  this->Shapes->setSortingEnabled(false);
  this->Shapes->setRowCount(0);
  for (const RelatedOrgan& organ : this->Found->Organs)
  {
    if (!organ.IsMeasured())
    {
      continue;
    }
    const auto of = [&](const char* key) { return ValueOf(organ.Features, key); };
    const int row = this->Shapes->rowCount();
    this->Shapes->insertRow(row);
    int column = 0;
    for (QTableWidgetItem* item :
         {RelationWords(organ.Name), RelationNumber(1e-3 * of("volume_mesh"), 2),
          RelationNumber(0.01 * of("surface_area"), 1), RelationNumber(of("major_axis_length"), 1),
          RelationNumber(of("minor_axis_length"), 1), RelationNumber(of("least_axis_length"), 1),
          RelationNumber(organ.Thick.Median, 1), RelationNumber(of("sphericity"), 3)})
    {
      this->Shapes->setItem(row, column++, item);
    }
  }
  this->Shapes->setSortingEnabled(true);
}

void RelationsPanel::ShowPlaceOf(int row)
{
  const auto pair = static_cast<std::size_t>(this->Pairs->item(row, 0)->data(PlaceRole).toInt());
  const MeshGap& wall = this->Found->Pairs[pair].Relation.Wall;
  Q_EMIT Chosen(0.5 * (wall.PointOfOne + wall.PointOfOther));
}

void RelationsPanel::Save()
{
  const QString folder = this->Questions.Folder(this, "Folder for the page and its tables");
  if (folder.isEmpty())
  {
    return;
  }
  this->Job->Run(
      [this, folder, found = this->Found](const ProgressFunction&)
      {
        WriteRelationFiles(*found, folder.toStdString());
        return [this, folder] { this->Job->End("Written: " + folder + "/report.html"); };
      });
}
} // namespace palpate
