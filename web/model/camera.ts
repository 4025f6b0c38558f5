/** From where the shape is looked at. */

export interface CameraPose {
  position: [number, number, number];
  target: [number, number, number];
}

/** The standard views. */
export type ViewName = 'home' | 'front' | 'top' | 'right';
