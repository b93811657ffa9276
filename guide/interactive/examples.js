// Metrics to begin with: the text, the two ends, and the centre and half side of the view.
const EXAMPLES = [
  {
    name: "Around a hill of cost",
    formula: "cost(1 + 4*exp(-2*(x1^2 + x2^2)))",
    about: "Length counts once far away, and five times on the top of the hill. Two ways lead around it: drag A across the line through B and the top, and they change places.",
    from: [-1.5, 0.1], to: [1.5, 0.05], centre: [0, 0], half: 2,
  },
  {
    name: "Refraction",
    formula: "speed(2 + tanh(8*x2))",
    about: "Light is three times as fast above as below. The way that takes the least time bends at the surface, as Snell's law says.",
    from: [-1.5, 1.4], to: [1.3, -1.5], centre: [0, 0], half: 2,
  },
  {
    name: "Over a mountain",
    formula: "graph(2*exp(-(x1^2 + x2^2)/2))",
    about: "The length of a path on the surface with this height, seen from above. Bring A and B close together, and the proof needs no assumption.",
    from: [-2, 0.15], to: [2, 0.3], centre: [0, 0], half: 3,
  },
  {
    name: "Robot arm",
    formula: "pullback(cos(x1) + cos(x1 + x2), sin(x1) + sin(x1 + x2), x1/2, x2/2)",
    about: "The two joint angles of an arm with two links. The metric measures how far the hand moves, and a little of how far the joints turn.",
    from: [-2, -2.2], to: [1.6, 2], centre: [0, 0], half: 3.2,
  },
  {
    name: "Normal distributions",
    formula: "[1/x2^2, 0; 0, 2/x2^2]",
    about: "Mean x1 and standard deviation x2, under the metric of Fisher and Rao: between narrow distributions the shortest way leads through wide ones.",
    from: [-1.5, 0.6], to: [1.5, 0.8], centre: [0, 2.05], half: 2,
  },
];
