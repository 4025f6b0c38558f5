export const stampsDir: string;
