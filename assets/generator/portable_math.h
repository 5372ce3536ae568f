// Sine, cosine, arc tangent and exponential from + - * / and sqrt alone, which IEEE 754 rounds in one way
// only: the C library's versions differ in the last bit between machines, and the sample assets must be the
// same bytes anywhere.
#pragma once

namespace relievo::assets {

inline constexpr double kPi = 3.14159265358979323846;

double sine(double radians);    // error under 1e-14 for |radians| < 1e4
double cosine(double radians);  // the same
double tangent(double radians);
double arc_tangent(double y, double x);  // of y / x in the right quadrant, [-pi, pi]; 0 for (0, 0)
double exponential(double x);            // 0 below -700

double clamp01(double x);
double mix(double a, double b, double t);
double smooth_step(double low, double high, double x);  // 0 at low, 1 at high, C1; low may exceed high
double dome(double x);                                  // 1 at 0, 0 from |x| = 1 on, C1: (1 - x^2)^2

}  // namespace relievo::assets
