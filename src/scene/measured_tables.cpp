// SPDX-License-Identifier: Apache-2.0
//
// The measurements: numbers as published, from the sources that are named beside them.
#include <array>

#include "scene/measured.h"

namespace snell::scene {

namespace {

constexpr IndexSample Silver[] = {{381.5, 0.05, 1.864}, {397.4, 0.05, 2.070}, {413.3, 0.05, 2.275},
                                  {430.5, 0.04, 2.462}, {450.9, 0.04, 2.657}, {471.4, 0.05, 2.869},
                                  {495.9, 0.05, 3.093}, {520.9, 0.05, 3.324}, {548.6, 0.06, 3.586},
                                  {582.1, 0.05, 3.858}, {616.8, 0.06, 4.152}, {659.5, 0.05, 4.483},
                                  {704.5, 0.04, 4.838}, {756.0, 0.03, 5.242}};
constexpr IndexSample Gold[] = {{381.5, 1.46, 1.933}, {397.4, 1.47, 1.952}, {413.3, 1.46, 1.958},
                                {430.5, 1.45, 1.948}, {450.9, 1.38, 1.914}, {471.4, 1.31, 1.849},
                                {495.9, 1.04, 1.833}, {520.9, 0.62, 2.081}, {548.6, 0.43, 2.455},
                                {582.1, 0.29, 2.863}, {616.8, 0.21, 3.272}, {659.5, 0.14, 3.697},
                                {704.5, 0.13, 4.103}, {756.0, 0.14, 4.542}};
constexpr IndexSample Copper[] = {{381.5, 1.33, 2.045}, {397.4, 1.32, 2.116}, {413.3, 1.28, 2.207},
                                  {430.5, 1.25, 2.305}, {450.9, 1.24, 2.397}, {471.4, 1.25, 2.483},
                                  {495.9, 1.22, 2.564}, {520.9, 1.18, 2.608}, {548.6, 1.02, 2.577},
                                  {582.1, 0.70, 2.704}, {616.8, 0.30, 3.205}, {659.5, 0.22, 3.747},
                                  {704.5, 0.21, 4.205}, {756.0, 0.24, 4.665}};
constexpr IndexSample Aluminium[] = {
    {364.7, 0.399, 4.396}, {413.3, 0.521, 5.001}, {442.8, 0.608, 5.368}, {476.9, 0.728, 5.778},
    {516.6, 0.873, 6.242}, {563.6, 1.073, 6.784}, {619.9, 1.366, 7.405}, {652.3, 1.572, 7.735},
    {688.8, 1.830, 8.060}, {729.3, 2.161, 8.357}, {774.9, 2.615, 8.491}};
constexpr IndexSample Brass[] = {{380, 1.487, 1.818}, {400, 1.445, 1.805}, {420, 1.350, 1.786},
                                 {440, 1.191, 1.797}, {460, 0.994, 1.883}, {480, 0.816, 2.046},
                                 {500, 0.686, 2.250}, {520, 0.602, 2.464}, {540, 0.549, 2.668},
                                 {560, 0.505, 2.860}, {580, 0.468, 3.059}, {600, 0.450, 3.253},
                                 {640, 0.444, 3.609}, {700, 0.446, 4.106}, {760, 0.458, 4.579}};
constexpr IndexSample Iron[] = {
    {381, 2.12, 2.50}, {397, 2.24, 2.58}, {413, 2.35, 2.65}, {431, 2.48, 2.71}, {451, 2.59, 2.77},
    {471, 2.67, 2.82}, {496, 2.74, 2.88}, {521, 2.86, 2.91}, {549, 2.95, 2.93}, {582, 2.94, 2.99},
    {617, 2.88, 3.05}, {659, 2.92, 3.10}, {704, 2.86, 3.19}, {756, 2.87, 3.28}};
constexpr IndexSample Chromium[] = {
    {381, 1.92, 2.74}, {397, 2.00, 2.83}, {413, 2.08, 2.93}, {431, 2.19, 3.04}, {451, 2.33, 3.14},
    {471, 2.51, 3.24}, {496, 2.75, 3.30}, {521, 2.94, 3.33}, {549, 3.18, 3.33}, {582, 3.22, 3.30},
    {617, 3.17, 3.30}, {659, 3.09, 3.34}, {704, 3.05, 3.39}, {756, 3.08, 3.42}};
constexpr IndexSample Nickel[] = {
    {381, 1.72, 2.48}, {397, 1.72, 2.57}, {413, 1.70, 2.69}, {431, 1.71, 2.82}, {451, 1.73, 2.95},
    {471, 1.78, 3.09}, {496, 1.82, 3.25}, {521, 1.85, 3.42}, {549, 1.92, 3.61}, {582, 1.96, 3.80},
    {617, 1.99, 4.02}, {659, 1.99, 4.26}, {704, 2.06, 4.50}, {756, 2.13, 4.73}};
constexpr IndexSample Titanium[] = {
    {381, 1.99, 2.93}, {397, 2.08, 2.95}, {413, 2.14, 2.98}, {431, 2.21, 3.01}, {451, 2.27, 3.04},
    {471, 2.32, 3.10}, {496, 2.36, 3.19}, {521, 2.44, 3.30}, {549, 2.54, 3.43}, {582, 2.60, 3.58},
    {617, 2.67, 3.72}, {659, 2.76, 3.84}, {704, 2.86, 3.96}, {756, 3.00, 4.01}};
constexpr IndexSample Platinum[] = {{400, 1.724, 2.852}, {450, 1.851, 3.140}, {500, 1.969, 3.421},
                                    {550, 2.091, 3.704}, {600, 2.224, 3.984}, {650, 2.370, 4.254},
                                    {700, 2.527, 4.509}, {750, 2.688, 4.746}};
constexpr IndexSample Tungsten[] = {{400, 3.316, 2.520}, {450, 3.370, 2.526}, {500, 3.389, 2.616},
                                    {550, 3.456, 2.757}, {600, 3.586, 2.864}, {650, 3.717, 2.884},
                                    {700, 3.776, 2.837}, {750, 3.734, 2.782}};

constexpr std::string_view NobleMetals = "Johnson and Christy 1972";
constexpr std::string_view TransitionMetals = "Johnson and Christy 1974";
constexpr std::string_view LorentzDrude = "Rakić et al. 1998, Lorentz-Drude model";
constexpr std::string_view Schott = "Schott";

constexpr std::array Metals = {MeasuredMetal{"gold", NobleMetals, Gold},
                               MeasuredMetal{"silver", NobleMetals, Silver},
                               MeasuredMetal{"copper", NobleMetals, Copper},
                               MeasuredMetal{"aluminium", "Rakić 1995", Aluminium},
                               MeasuredMetal{"brass", "Querry 1985", Brass},
                               MeasuredMetal{"iron", TransitionMetals, Iron},
                               MeasuredMetal{"chromium", TransitionMetals, Chromium},
                               MeasuredMetal{"nickel", TransitionMetals, Nickel},
                               MeasuredMetal{"titanium", TransitionMetals, Titanium},
                               MeasuredMetal{"platinum", LorentzDrude, Platinum},
                               MeasuredMetal{"tungsten", LorentzDrude, Tungsten}};

constexpr std::array Glasses = {
    MeasuredGlass{"BK7",
                  Schott,
                  {1.03961212, 0.231792344, 1.01046945},
                  {0.00600069867, 0.0200179144, 103.560653}},
    MeasuredGlass{"F5",
                  Schott,
                  {1.3104463, 0.19603426, 0.96612977},
                  {0.00958633048, 0.0457627627, 115.011883}},
    MeasuredGlass{"SF10",
                  Schott,
                  {1.61625977, 0.259229334, 1.07762317},
                  {0.0127534559, 0.0581983954, 116.60768}},
    MeasuredGlass{"SF11",
                  Schott,
                  {1.73848403, 0.311168974, 1.17490871},
                  {0.0136068604, 0.0615960463, 121.922711}},
    MeasuredGlass{"LASF9",
                  Schott,
                  {2.00029547, 0.298926886, 1.80691843},
                  {0.0121426017, 0.0538736236, 156.530829}},
    MeasuredGlass{"fused silica",
                  "Malitson 1965",
                  {0.6961663, 0.4079426, 0.8974794},
                  {0.0684043 * 0.0684043, 0.1162414 * 0.1162414, 9.896161 * 9.896161}},
    MeasuredGlass{"water",
                  "Daimon and Masumura 2007, 20 °C",
                  {0.5684027565, 0.1726177391, 0.02086189578, 0.1130748688},
                  {0.005101829712, 0.01821153936, 0.02620722293, 10.69792721}},
    MeasuredGlass{"acrylic", "Sultanova et al. 2009", {1.1819}, {0.011313}},
    MeasuredGlass{"polycarbonate", "Sultanova et al. 2009", {1.4182}, {0.021304}},
    MeasuredGlass{"sapphire",
                  "Malitson and Dodge 1972, ordinary ray",
                  {1.4313493, 0.65054713, 5.3414021},
                  {0.0726631 * 0.0726631, 0.1193242 * 0.1193242, 18.028251 * 18.028251}},
    MeasuredGlass{"zirconia",
                  "Wood and Nassau 1982",
                  {1.347091, 2.117788, 9.452943},
                  {0.062543 * 0.062543, 0.166739 * 0.166739, 24.32057 * 24.32057}},
    MeasuredGlass{"diamond", "Peter 1923", {0.3306, 4.3356}, {0.175 * 0.175, 0.106 * 0.106}}};

}  // namespace

std::span<const MeasuredMetal> MeasuredMetals() { return Metals; }
std::span<const MeasuredGlass> MeasuredGlasses() { return Glasses; }

}  // namespace snell::scene
