#include "StudyProduct.h"

#include "CaseText.h"

#include "vtkImageData.h"

namespace palpate
{
namespace
{
template <typename... Visitors>
struct Overloaded : Visitors...
{
  using Visitors::operator()...;
};
template <typename... Visitors>
Overloaded(Visitors...) -> Overloaded<Visitors...>;

std::size_t BytesOf(vtkDataObject* data)
{
  constexpr std::size_t Kibibyte = 1024;
  return data != nullptr ? Kibibyte * data->GetActualMemorySize() : 0;
}

std::string SentenceOf(const FitResult& result)
{
  return CaseSentence(result.Input, result.Structure, result.Message);
}
} // namespace

std::string FailureOf(const StudyProduct& product)
{
  return std::visit(
      Overloaded{[](const StudyFailure& failure) { return failure.Sentence; },
                 [](const std::shared_ptr<const FitSurface>& surface)
                 { return surface->IsOver ? SentenceOf(surface->Found) : std::string(); },
                 [](const std::shared_ptr<const FitSamples>& samples)
                 { return samples->IsOver ? SentenceOf(samples->Found) : std::string(); },
                 [](const std::shared_ptr<const FitResult>& fit) {
                   return fit->State != FitResult::Outcome::Fitted ? SentenceOf(*fit)
                                                                   : std::string();
                 },
                 [](const auto&) { return std::string(); }},
      product);
}

std::size_t BytesOf(const StudyProduct& product)
{
  return std::visit(
      Overloaded{
          [](const StudyFailure& failure) { return failure.Sentence.size(); },
          [](const std::shared_ptr<const Volume>& volume) { return BytesOf(volume->Image.Get()); },
          [](const std::shared_ptr<const Segmentation>& segmentation)
          {
            std::size_t bytes = 0;
            for (const auto& layer : segmentation->Layers)
            {
              bytes += BytesOf(layer.Get());
            }
            return bytes;
          },
          [](const std::shared_ptr<const FitSurface>& surface)
          { return BytesOf(surface->Found.Surface.Get()) + BytesOf(surface->Boundary.Get()); },
          [](const std::shared_ptr<const FitSamples>& samples)
          { return BytesOf(samples->Samples.Get()); },
          [](const std::shared_ptr<const FitResult>& fit)
          { return BytesOf(fit->ModelSurface.Get()); },
          [](const std::shared_ptr<const ScalarField>& field)
          { return static_cast<std::size_t>(field->Memory().Bytes); },
          [](const std::shared_ptr<const TouchContact>& contact)
          {
            // A tree of boxes over the facets takes about as much as they do.
            return sizeof(*contact) + 2 * BytesOf(contact->Looks.Surface.Get());
          },
          [](const std::shared_ptr<const TouchCost>& cost) { return sizeof(*cost); }},
      product);
}
} // namespace palpate
