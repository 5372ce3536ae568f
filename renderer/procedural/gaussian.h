// The Gaussian of mean 1/2 and deviation 1/6, truncated at three deviations so that it fills [0, 1] (Burley
// 2019).
#pragma once

namespace relievo {

// The part of the distribution below `g`, of [0, 1]; 0 below and 1 above.
double gaussian_share(double g);
// Its inverse: the value in [0, 1] below which the part `share` of [0, 1] lies.
double gaussian_value(double share);

}  // namespace relievo
