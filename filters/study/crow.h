/// The questions that a lecture on texture mapping leaves open beside Crow's figure of 1984, asked of the
/// methods themselves: what a mip map returns for a 5 x 5 neighbourhood, how far between two levels that is,
/// and what becomes of a region that is not square.
#pragma once

#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace zproof::study {

/// The weights that a method gives to the texels of level 0 around one place.
struct Kernel {
    int columns = 0, rows = 0;
    std::vector<double> weights;  ///< row by row; the whole texture, which repeats
    double sum = 0;
    glm::dvec2 deviation{0};  ///< standard deviation across and down, texels
};

struct CrowAnswer {
    std::string method;  ///< "exact" for the mean over the region itself
    Kernel kernel;       ///< at the first place
    double value = 0;    ///< returned at the first place, a number of [0, 1]
    double texels = 0;   ///< read per lookup
    double rmse = 0;     ///< against the exact mean, over all places
};

/// A region of texels, and what each method makes of it.
struct CrowQuestion {
    std::string region;               ///< "5 x 5"
    glm::dvec2 centre{0};             ///< of the first place, texels
    glm::dvec2 per_x{0}, per_y{0};    ///< its sides, texels
    std::vector<CrowAnswer> answers;  ///< the exact one first
};

/// How far a square of this side lies between two levels of a mip map.
struct BetweenLevels {
    double side = 0;          ///< texels
    int level = 0;            ///< the finer one, whose texels are 2^level texels wide
    double by_logarithm = 0;  ///< log2(side) - level: Williams, OpenGL
    double by_width = 0;      ///< (side - 2^level) / 2^level
    double rmse = 0;          ///< of trilinear-gl there, against the exact mean
};

struct CrowAnswers {
    int texture_side = 0, places = 0;  ///< of the noise that is asked about
    std::vector<CrowQuestion> questions;
    std::vector<BetweenLevels> levels;
};

/// The answers are the same every time. The texture is white noise, uniform in [0, 1], which repeats.
CrowAnswers crow_answers();

/// The exact mean's weights over the parallelogram with this centre and these sides, on a repeating texture
/// that the region is not larger than.
Kernel exact_kernel(int texture_side, const glm::dvec2& centre, const glm::dvec2& per_x,
                    const glm::dvec2& per_y);

}  // namespace zproof::study
