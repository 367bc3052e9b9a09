#include "StartPage.h"

#include "SampleData.h"
#include "ScreenString.h"
#include "StudyFile.h"
#include "StudyThumbnails.h"

#include <QFileInfo>
#include <QPushButton>

#include <algorithm>

namespace palpate
{
namespace
{
constexpr int MostListed = 6;
constexpr int MostColumns = 3;
constexpr int LeastCard = 280; // pixels
constexpr int LeastRecent = 190;
constexpr int MostWidth = 1080;
constexpr int CardLines = 5;
constexpr int Margin = 12;
const QSize CardPicture(88, 66);
const QSize RecentPicture(64, 48);
} // namespace

StartPage::StartPage(QWidget* parent) : QScrollArea(parent)
{
  this->setObjectName("start");
  this->setFrameShape(QFrame::NoFrame);
  this->setWidgetResizable(true);
  this->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  this->setFocusPolicy(Qt::NoFocus);
  auto* page = new QWidget(this);
  this->Column = new QVBoxLayout(page);
  this->Column->setSpacing(8);
  this->AddOpening();
  this->RecentHeading = this->AddHeading("Recent");
  this->Recent = new TileGrid(LeastRecent, MostColumns, page);
  this->Recent->setObjectName("start-recent");
  this->Column->addWidget(this->Recent);
  this->AddHeading("Try it");
  this->Cards = new TileGrid(LeastCard, MostColumns, page);
  this->Cards->setObjectName("start-cards");
  this->Column->addWidget(this->Cards);
  this->Column->addStretch(1);
  this->AddCards();
  this->ShowRecent({});
  this->setWidget(page);
}

// Lines of text that are too long cannot be read.
void StartPage::resizeEvent(QResizeEvent* event)
{
  const int margin = std::max(Margin, (this->viewport()->width() - MostWidth) / 2);
  this->Column->setContentsMargins(margin, Margin, margin, Margin);
  QScrollArea::resizeEvent(event);
}

QLabel* StartPage::AddHeading(const QString& text)
{
  auto* heading = new QLabel(text, this);
  QFont font = heading->font();
  font.setBold(true);
  font.setPointSizeF(1.15 * font.pointSizeF());
  heading->setFont(font);
  heading->setContentsMargins(0, 8, 0, 0);
  this->Column->addWidget(heading);
  return heading;
}

void StartPage::AddOpening()
{
  auto* title = new QLabel("Drop files here, or open them", this);
  QFont large = title->font();
  large.setPointSizeF(1.5 * large.pointSizeF());
  title->setFont(large);
  auto* open = new QPushButton("Open files...", this);
  open->setObjectName("start-open");
  auto* folder = new QPushButton("Open folder...", this);
  folder->setObjectName("start-folder");
  connect(open, &QPushButton::clicked, this, &StartPage::OpenAsked);
  connect(folder, &QPushButton::clicked, this, &StartPage::FolderAsked);
  auto* row = new QHBoxLayout;
  row->addWidget(open);
  row->addWidget(folder);
  row->addStretch(1);
  auto* kinds =
      new QLabel("Volumes, segmentations, DICOM slices, models, surfaces, scenes, studies "
                 "and recordings.",
                 this);
  kinds->setWordWrap(true);
  this->Column->addWidget(title);
  this->Column->addWidget(kinds);
  this->Column->addLayout(row);
}

void StartPage::AddCards()
{
  for (const StartCard& card : StartCard::All())
  {
    const StartCard::Kind kind = card.Is;
    auto* tile = new StartTile(
        card.Title, card.Text, CardLines, CardPicture,
        [kind](const QSize& size) { return DrawCard(kind, size); }, this->Cards);
    tile->setObjectName(QString("card-") + card.Key);
    connect(tile, &StartTile::clicked, this, [this, kind] { Q_EMIT this->CardChosen(kind); });
    if (kind == StartCard::Kind::Head && !SampleData::Head().IsThere())
    {
      tile->setEnabled(false);
      tile->ShowText("Install Debian's package " + SampleData::Head().Package + " to see it.");
    }
    this->OfKind[kind] = tile;
    this->Cards->Add(tile);
  }
}

void StartPage::ShowProgress(StartCard::Kind kind, const QString& text)
{
  if (this->OfKind.at(kind)->isEnabled())
  {
    this->OfKind.at(kind)->ShowText(text);
  }
}

void StartPage::ShowRecent(const QStringList& files)
{
  this->Recent->Clear();
  for (const QString& file : files.mid(0, MostListed))
  {
    const QFileInfo information(file);
    QString name = information.fileName();
    name.chop(name.endsWith(StudyEnding) ? QString(StudyEnding).size() : 0);
    auto* tile = new StartTile(
        ScreenString(name.toStdString()), ScreenString(information.path().toStdString()), 2,
        RecentPicture, [file](const QSize& size) { return StudyThumbnails::PictureOf(file, size); },
        this->Recent);
    tile->setToolTip(PlainToolTip(ScreenString(file.toStdString())));
    connect(tile, &StartTile::clicked, this, [this, file] { Q_EMIT this->FileChosen(file); });
    this->Recent->Add(tile);
  }
  this->RecentHeading->setVisible(!files.isEmpty());
  this->Recent->setVisible(!files.isEmpty());
}
} // namespace palpate
