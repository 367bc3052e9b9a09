#pragma once

namespace palpate
{
/// P(|T| >= |t|) of Student's distribution; 1 if t is not a number.
double StudentTwoSided(double t, double degrees);
/// The t with P(|T| <= t) = `confidence`, 0 < confidence < 1.
double StudentQuantile(double confidence, double degrees);
/// P(F >= f) of Fisher's distribution; 1 if f is not a number or negative.
double FisherUpper(double f, double numerator, double denominator);
/// The f with P(F >= f) = `probability`, 0 < probability < 1.
double FisherUpperQuantile(double probability, double numerator, double denominator);
} // namespace palpate
