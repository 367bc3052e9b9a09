#include "StartPage.h"

#include "SampleData.h"
#include "ScreenString.h"

#include <QFileInfo>
#include <QPushButton>
#include <QUrl>

namespace palpate
{
namespace
{
constexpr int MostListed = 8;
constexpr QChar Separator('\n'); // between files of a link

QString Link(const QStringList& files, const QString& text, const QString& remark)
{
  const QString address = QUrl::toPercentEncoding(files.join(Separator));
  return QString("<p style='margin:3px'><a href=\"%1\">%2</a> &nbsp; %3</p>")
      .arg(address, text.toHtmlEscaped(), remark.toHtmlEscaped());
}
} // namespace

StartPage::StartPage(QWidget* parent) : QWidget(parent), Column(new QVBoxLayout(this))
{
  this->setObjectName("start");
  auto* title = new QLabel("Drop files here", this);
  QFont large = title->font();
  large.setPointSizeF(1.8 * large.pointSizeF());
  title->setFont(large);
  title->setAlignment(Qt::AlignCenter);
  auto* kinds =
      new QLabel("a volume, a segmentation, a folder of DICOM slices, a model, a surface, a "
                 "scene, a study or a recording",
                 this);
  kinds->setAlignment(Qt::AlignCenter);
  kinds->setWordWrap(true);
  auto* open = new QPushButton("Open files...", this);
  open->setObjectName("start-open");
  auto* folder = new QPushButton("Open DICOM folder...", this);
  folder->setObjectName("start-folder");
  connect(open, &QPushButton::clicked, this, &StartPage::OpenAsked);
  connect(folder, &QPushButton::clicked, this, &StartPage::FolderAsked);
  auto* buttons = new QHBoxLayout;
  buttons->addStretch(1);
  buttons->addWidget(open);
  buttons->addWidget(folder);
  buttons->addStretch(1);
  this->Column->addStretch(1);
  this->Column->addWidget(title);
  this->Column->addWidget(kinds);
  this->Column->addSpacing(12);
  this->Column->addLayout(buttons);
  this->Column->addSpacing(12);
  this->Samples = this->AddLinks("start-samples");
  this->Recent = this->AddLinks("start-recent");
  this->Column->addStretch(2);
  this->ShowSamples();
}

QLabel* StartPage::AddLinks(const char* name)
{
  auto* label = new QLabel(this);
  label->setObjectName(name);
  label->setTextFormat(Qt::RichText);
  label->setTextInteractionFlags(Qt::LinksAccessibleByMouse | Qt::LinksAccessibleByKeyboard);
  label->setFocusPolicy(Qt::StrongFocus);
  label->setAlignment(Qt::AlignCenter);
  label->setWordWrap(true);
  connect(label, &QLabel::linkActivated, this,
          [this](const QString& link)
          {
            const QString files = QUrl::fromPercentEncoding(link.toUtf8());
            Q_EMIT FilesChosen(files.split(Separator));
          });
  this->Column->addWidget(label);
  return label;
}

void StartPage::ShowSamples()
{
  QString text;
  for (const SampleData& sample : SampleData::All())
  {
    text += sample.IsThere() ? Link(sample.Files, sample.Title, {})
                             : QString("<p>%1: install %2</p>").arg(sample.Title, sample.Package);
  }
  this->Samples->setText("<b>Sample data</b>" + text);
}

void StartPage::ShowRecent(const QStringList& files)
{
  QString text;
  for (const QString& file : files.mid(0, MostListed))
  {
    const QFileInfo information(file);
    text += Link({file}, ScreenString(information.fileName().toStdString()),
                 ScreenString(information.path().toStdString()));
  }
  this->Recent->setText(text.isEmpty() ? QString() : "<b>Recent</b>" + text);
}
} // namespace palpate
